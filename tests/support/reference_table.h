// Tables of tests/data: rows of numbers computed independently of the program; each file names its
// source. SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace facet::test {

/// One row by column name; text columns (a model's name) are apart.
struct ReferenceRow {
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;
    std::string shown;  ///< the row as JSON, for a failing test's message

    [[nodiscard]] double operator[](const std::string& column) const { return numbers.at(column); }
};

/// Every row of tests/data/NAME.json. Throws where the file is missing or has no rows: a test must
/// not pass empty.
inline std::vector<ReferenceRow> reference_rows(const std::string& name) {
    const std::string path = std::string(FACET_SOURCE_DIR) + "/tests/data/" + name + ".json";
    std::ifstream file(path);
    const nlohmann::json table = nlohmann::json::parse(file);
    std::vector<std::string> columns = table.at("inputs");
    for (const nlohmann::json& output : table.at("outputs")) columns.push_back(output);
    std::vector<ReferenceRow> rows;
    for (const nlohmann::json& values : table.at("rows")) {
        ReferenceRow row{.numbers = {}, .texts = {}, .shown = name + " " + values.dump()};
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const nlohmann::json& cell = values.at(i);
            if (cell.is_string())
                row.texts[columns[i]] = cell;
            else
                row.numbers[columns[i]] = cell;
        }
        rows.push_back(std::move(row));
    }
    if (rows.empty()) throw std::runtime_error(path + ": no rows");
    return rows;
}

}  // namespace facet::test
