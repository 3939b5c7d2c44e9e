// `check`: every problem of a file, in the words of the Khronos glTF-Validator.
// SPDX-License-Identifier: MIT
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "gltf_fixture.h"

namespace facet::test {
namespace {

namespace fs = std::filesystem;
using support::TemporaryFolder;
using Severity = scene::Finding::Severity;

std::vector<scene::Finding> findings_of(const std::string& text) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "model.gltf";
    std::ofstream(path, std::ios::binary) << text;
    auto findings = scene::check(path.string(), {}, {});
    EXPECT_TRUE(findings.has_value());
    return findings ? std::move(*findings) : std::vector<scene::Finding>{};
}

bool has(const std::vector<scene::Finding>& findings, const std::string& code,
         const std::string& pointer) {
    return std::any_of(findings.begin(), findings.end(), [&](const scene::Finding& f) {
        return f.code == code && f.pointer == pointer;
    });
}

bool has_errors(const std::vector<scene::Finding>& findings) {
    return std::any_of(findings.begin(), findings.end(),
                       [](const scene::Finding& f) { return f.severity == Severity::error; });
}

TEST(Check, a_sound_file_has_no_errors_and_no_warnings) {
    for (const scene::Finding& finding : findings_of(triangle().text()))
        EXPECT_GT(finding.severity, Severity::warning) << finding.code << finding.pointer;
}

TEST(Check, finds_every_problem_and_not_only_the_first) {
    Document d = triangle();
    d.json["nodes"][0]["mesh"] = 7;
    d.json["nodes"][0]["rotation"] = {0, 0, 0, 2};
    d.json["cameras"] = {Json::object()};
    primitive(d)["attributes"]["NORMAL"] = 99;
    d.json["typo"] = 1;
    const auto findings = findings_of(d.text());
    EXPECT_TRUE(has(findings, "UNRESOLVED_REFERENCE", "/nodes/0/mesh"));
    EXPECT_TRUE(has(findings, "VALUE_NOT_IN_RANGE", "/nodes/0/rotation/3"));
    EXPECT_TRUE(has(findings, "ROTATION_NON_UNIT", "/nodes/0/rotation"));
    EXPECT_TRUE(has(findings, "UNDEFINED_PROPERTY", "/cameras/0"));
    EXPECT_TRUE(has(findings, "UNRESOLVED_REFERENCE", "/meshes/0/primitives/0/attributes/NORMAL"));
    EXPECT_TRUE(has(findings, "UNEXPECTED_PROPERTY", "/typo"));
}

TEST(Check, looks_into_the_buffers) {
    Document d = triangle();
    d.json["accessors"][0]["max"] = {2, 1, 0};
    primitive(d)["indices"] = d.accessor<std::uint16_t>("SCALAR", 5123, 3, {0, 1, 9});
    primitive(d)["attributes"]["NORMAL"] = d.floats("VEC3", 3, {0, 0, 1, 0, 0, 2, 0, 0, 1});
    const auto findings = findings_of(d.text());
    EXPECT_TRUE(has(findings, "ACCESSOR_MAX_MISMATCH", "/accessors/0/max/0"));
    EXPECT_TRUE(has(findings, "ACCESSOR_INDEX_OOB", "/meshes/0/primitives/0/indices"));
    EXPECT_TRUE(
        has(findings, "ACCESSOR_VECTOR3_NON_UNIT", "/meshes/0/primitives/0/attributes/NORMAL"));
}

TEST(Check, an_extension_that_is_not_supported_is_no_error) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_texture_basisu"};
    d.json["extensionsRequired"] = {"KHR_texture_basisu"};
    EXPECT_FALSE(has_errors(findings_of(d.text())));
}

TEST(Check, knows_what_lets_light_into_a_volume_and_what_scatters_there) {
    Document d = triangle();
    d.json["extensionsUsed"] = {"KHR_materials_diffuse_transmission", "KHR_materials_volume",
                                "KHR_materials_volume_scatter"};
    Json& extensions = d.json["materials"][0]["extensions"];
    extensions = {{"KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 1}}},
                  {"KHR_materials_volume", {{"thicknessFactor", 1}}},
                  {"KHR_materials_volume_scatter", {{"multiscatterColorFactor", {1, 1, 1}}}}};
    primitive(d)["material"] = 0;
    for (const scene::Finding& finding : findings_of(d.text()))
        EXPECT_GT(finding.severity, Severity::warning) << finding.code << finding.pointer;
    extensions["KHR_materials_diffuse_transmission"]["diffuseTransmissionFactor"] = 2;
    extensions["KHR_materials_volume_scatter"]["scatterAnisotropy"] = 1;
    const auto findings = findings_of(d.text());
    const std::string at = "/materials/0/extensions/KHR_materials_";
    EXPECT_TRUE(
        has(findings, "VALUE_NOT_IN_RANGE", at + "diffuse_transmission/diffuseTransmissionFactor"));
    EXPECT_TRUE(has(findings, "VALUE_NOT_IN_RANGE", at + "volume_scatter/scatterAnisotropy"));
}

TEST(Check, keys_with_slashes_are_escaped_in_pointers) {
    Document d = triangle();
    d.json["a/b~c"] = 1;
    EXPECT_TRUE(has(findings_of(d.text()), "UNEXPECTED_PROPERTY", "/a~1b~0c"));
}

TEST(Check, text_that_is_no_json_is_one_finding_and_a_missing_file_an_error) {
    const auto findings = findings_of("{");
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].code, "INVALID_JSON");
    EXPECT_FALSE(scene::check("/nonexistent/file.gltf", {}, {}).has_value());
}

/// Codes of the errors in a golden report of the validator.
std::vector<std::string> golden_codes(const fs::path& report) {
    std::ifstream file(report);
    const Json json = Json::parse(file);
    std::vector<std::string> codes;
    for (const Json& message : json["issues"]["messages"])
        if (message["severity"] == 0) codes.push_back(message["code"]);
    return codes;
}

TEST(CheckCorpus, agrees_with_the_validators_own_reports) {
    const fs::path corpus = fs::path(FACET_SOURCE_DIR) / "../shared/assets/validator";
    if (!fs::is_directory(corpus)) GTEST_SKIP() << "no corpus beside the sources";
    std::size_t count = 0;
    std::size_t agreed = 0;
    for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
        const std::string path = entry.path().string();
        constexpr std::string_view ending = ".report.json";
        if (!path.ends_with(ending)) continue;
        const std::string model = path.substr(0, path.size() - ending.size());
        const auto findings = scene::check(model, {}, {});
        ASSERT_TRUE(findings.has_value()) << model;
        const bool agrees = has_errors(*findings) == !golden_codes(entry.path()).empty();
        if (!agrees) std::printf("differs: %s\n", model.c_str());
        agreed += agrees ? 1 : 0;
        ++count;
    }
    EXPECT_EQ(count, 372U);
    EXPECT_EQ(agreed, count);
}

}  // namespace
}  // namespace facet::test
