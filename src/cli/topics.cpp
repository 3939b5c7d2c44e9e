// The longer help: facet help TOPIC, written from the tables where a table knows.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "cli/help.h"
#include "cli/setting_flags.h"
#include "studio/actions.h"
#include "tables/aovs.h"
#include "tables/brdf_terms.h"
#include "tables/exit_codes.h"
#include "tables/lights.h"
#include "tables/material.h"
#include "tables/qualities.h"
#include "tables/settings_text.h"
#include "teach/ask.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace facet::cli {
namespace {

std::string lights() {
    std::string out =
        "Example: facet render a.glb --light \"directional:azimuth=30,elevation=45,lux=3\"\n\n"
        "--light KIND:key=value,... adds a light; give it again for more. --no-file-lights drops "
        "the file's own.\n"
        "azimuth 0 is light from +z, 90 from +x; elevation 90 from above. Degrees, metres; vectors "
        "as \"x y z\".\n"
        "color is #rrggbb or \"r g b\" linear; temperature is in kelvin. inner and outer are half "
        "angles of a cone.\n"
        "shadow=off: nothing keeps the light off. Without a number: 3 lux, 10 candela, 10 nit; an "
        "IES file has its own\n"
        "(--list lamps: those that come along).\n";
    out +=
        "Kinds with a size (nit) light by rays, in raster and reference alike; with --shadows maps "
        "or off by linearly\ntransformed cosines. Maps have room for some 40 lights; those after "
        "them cast no shadow.\n\n";
    for (const auto& row : tables::light_kinds)
        out += fmt::format("{:<12} {} Unit: {}.\n{:<12} keys: {}\n", row.key, row.help, row.unit,
                           "", row.keys);
    return out;
}

std::string quality() {
    std::string out =
        "Example: facet render a.glb --quality final -o a.png\n\n"
        "A picture is the mean of some frames, each through another place of its pixels "
        "(--samples). "
        "Rays find what the\n"
        "frames cannot see: the shadow of every light, at each frame; and at the middles of "
        "pixels, "
        "by paths as those of\n"
        "--reference, how much of the environment arrives and what other surfaces send. That is "
        "smoothed over each surface.\n"
        "More paths are drawn where the first ones disagree. --shadows off leaves all rays "
        "out. --shadows maps is\nwhat rasterisers do in their place: shadow maps, wider with the "
        "light's size, and the horizon in the depth\nbuffer for the environment; no light between "
        "surfaces.\n\n";
    for (const tables::Quality& row : tables::qualities)
        out += fmt::format("{:<9} {:>2} frames, {} to {} paths, {} bounces at most: {}\n", row.key,
                           row.frames, row.rays.samples, row.rays.most_samples, row.rays.bounces,
                           row.help);
    return out + "\ndocs/fidelity.md has how long each takes and how far it is from the truth.\n";
}

std::string cameras() {
    return "Example: facet render a.glb --camera orbit:azimuth=30,elevation=15\n\n"
           "--camera auto       the file's first camera, or one framed on the model (the default)\n"
           "--camera NAME       a camera of the file, by its name or its node's; --camera 2 by "
           "index\n"
           "--camera orbit:...  azimuth, elevation in degrees (where the eye is: 0 is +z, 90 is "
           "+x, 90 up is above),\n"
           "                    distance in metres (default: fits the model), target \"x y z\" "
           "(default: its middle);\n"
           "                    fit=turn fits it at every azimuth, fit=sphere the sphere around "
           "it\n"
           "--fov DEG           vertical angle of view; it stays when the picture's shape differs "
           "from the camera's\n"
           "--aperture N        f-number of a lens before a frame 24 mm high: depth of field, by "
           "four "
           "times as many samples;\n"
           "                    --focus M is what is sharp, --blades N the corners of its blur\n"
           "--shutter S --iso S with the aperture give the exposure, 1 / (1.2 N^2 / S * 100 / "
           "ISO)\n"
           "--time S            plays an animation of the file (--animation NAME|INDEX, else the "
           "first), which moves its cameras\n"
           "                    too; others are aimed at the model as it begins. --shutter S then "
           "blurs what moves, S/2 before\n"
           "                    and after, with or without an aperture\n"
           "--projection        orthographic: as large as the scene's middle was in perspective; "
           "panorama: all around,\n"
           "                    latitude by longitude with what is ahead in the middle, as --env "
           "reads it\n"
           "--vignette          natural: cos^4 of the angle to the axis; full: and the rim of a "
           "barrel as wide as f/1.4,\n"
           "                    which apertures from f/7 on do not touch\n"
           "--motion-blur       how the camera moves while the shutter is open, around where it "
           "stands: move=X Y Z\n"
           "                    (metres to the right, up and back), turn=DEG to the left, "
           "orbit=DEG around the model;\n"
           "                    a turntable of 36 with a shutter open half the time is orbit=5\n"
           "--distortion K      r (1 + K r^2) is where a lens without faults has what shows at "
           "r, 1 at the corner\n"
           "--white-balance K   light of this temperature shows white; --gamut p3 or rec2020-pq "
           "writes a .png that says so\n"
           "--tonemap ocio      or ocio:VIEW, ocio:DISPLAY/VIEW: of the OpenColorIO configuration "
           "that the variable OCIO names\n"
           "facet render a.glb --list cameras  names the cameras of a file\n";
}

std::string jobs() {
    return "Example: facet batch thumbnails.json --report thumbnails.html\n\n"
           "{ \"facet\": 1,\n"
           "  \"output\": \"out/{scene}-{index:04}.png\",\n"
           "  \"defaults\": { \"size\": [256, 256] },\n"
           "  \"items\": [ { \"scene\": \"models/**/*.glb\", \"camera\": [\"auto\", "
           "\"orbit:azimuth=90\"],\n"
           "               \"set\": { \"material.*.roughness\": [0.1, 0.9] } } ] }\n\n"
           "Keys are the options of facet render with underscores; every list is an axis, and axes "
           "multiply, save where\nthe value itself is a list (size, vectors, light, aov, material: "
           "there an axis is a list of lists).\n"
           "\"frames\": {\"orbit\": 36} is a turntable; {\"random\": [0, 1], \"count\": 50, "
           "\"seed\": 7} an axis of chance, without a count\na draw for each item; \"camera\": "
           "{\"sphere\": 200} cameras all around.\n"
           "Placeholders: {scene} {folder} {index} {frame} {camera} and every key; {index:05} "
           "pads.\n"
           "Paths are relative to the job file. State lies in JOB.facet/: the same command goes on "
           "where it was.\n"
           "facet batch --schema prints the form for editors; docs/batch.md has the whole of it.\n";
}

std::string lessons() {
    std::string out =
        "Example: facet teach --new my-lesson && facet teach ./my-lesson -o pages\n\n"
        "A lesson is a folder: lesson.json (pictures, plots, numbers, the canvas) and a text in "
        "Markdown for each language.\n"
        "In the text ![caption](strip:NAME), plot:NAME, number:NAME and live:canvas stand for what "
        "lesson.json has under that name.\n"
        "Formulas are LaTeX between $ or $$: \\frac \\sqrt \\left \\right \\text \\mathbf, Greek, "
        "sums, functions, aligned.\ndocs/lessons.md has the whole form.\n\n"
        "What numbers and curves may ask for\n";
    for (const auto& ask : teach::ask_names())
        out += fmt::format("  {:<15} {}\n", ask.name, ask.help);
    return out;
}

std::string studio() {
    std::string out =
        "Example: facet studio helmet.glb\n\n"
        "Drag turns the view, Shift or the right button pans, the wheel zooms; right button and "
        "WASD, QE fly; Alt turns the environment.\n"
        "A click chooses a material. Drop a .gltf, .glb, .hdr or .exr on the window, or a picture "
        "on a texture's row.\n\nKeys\n";
    for (const auto& row : facet::studio::actions)
        if (!row.keys.empty())
            out += fmt::format("  {:<14} {}\n", facet::studio::shown_keys(row.keys), row.name);
    return out +
           "\n--do SCRIPT plays a file, one step a line; # begins a comment, words with spaces "
           "stand in quotes\n"
           "  set PATH VALUE    what --set takes, or a setting's key and value\n"
           "  click LABEL       a widget, by the name that a mistake lists\n"
           "  drag LABEL X [Y]  a slider to the value X; anything else by X and Y pixels\n"
           "  key NAME          ctrl+z, f1, ...; type TEXT writes into the field in use\n"
           "  open FILE, save FILE, undo, redo, quit\n"
           "  wait [N]          N frames; without N until the picture is finished\n"
           "  truth N           until the reference has N samples a pixel\n"
           "  shot FILE         the window as a PNG\n"
           "--offscreen needs no display; its pictures are the same on any machine.\n"
           "Unsaved work is kept in XDG_STATE_HOME/facet, habits in XDG_CONFIG_HOME/facet.\n";
}

std::string set() {
    std::string out =
        "Example: facet render a.glb --set material.Helmet.roughness=0.4 --set "
        "material.*.metallic=1\n\n"
        "--set PATH=VALUE changes the scene before it is rendered; give it again for more. A PATH "
        "is\n"
        "material.NAME.KEY, material.*.KEY for all, or material[3].KEY by index; light.NAME.KEY "
        "likewise.\n"
        "A number is a factor: a texture still multiplies it. KEY_texture=none drops a "
        "texture,\n"
        "KEY_texture=FILE puts a picture in its place. --material NAME=PRESET comes before: "
        "--list materials.\n\n";
    for (const auto& row : tables::material_params)
        out += fmt::format("  {:<20} {:>5} .. {:<8} {}\n", row.key, row.range.low, row.range.high,
                           row.help);
    for (const auto& row : tables::material_textures)
        out += fmt::format("  {:<36} {}\n", fmt::format("{}=none", row.key), row.help);
    return out;
}

std::string aovs() {
    std::string out =
        "Example: facet render a.glb -o a.exr --aov albedo,normal,depth\n\n"
        "--aov LIST or --aov all: further outputs. Into an EXR as layers NAME.CHANNEL, beside "
        "other formats as\n"
        "STEM.NAME.png. Ids and depth are never averaged.\n\n"
        "The key light is the first --light; else the light that lights the middle of the scene "
        "most; else the\n"
        "side that the environment's light comes from (its mean direction).\n\n"
        "Light paths add up to the beauty before tone mapping. Direct is from lights and, in the "
        "reference, from\n"
        "meshes that emit; the environment is indirect. With --shadows traced, lights with a size "
        "count as indirect\n"
        "too. Side files of them have the picture's exposure.\n\n";
    for (const auto& row : tables::aovs)
        out += fmt::format("  {:<17} {:<5} {}\n", row.key, row.channels, row.help);
    return out;
}

std::string more() {
    std::string out =
        "Example: facet render a.glb --allow-read ../textures --max-memory 2048 --strict\n\n"
        "Limits on what a scene may take and read, and what else is seldom wanted. Each may stand "
        "in the environment too:\nFACET_MAX_MEMORY=2048. Compiled shaders and baked environments "
        "(256 MB of them at most) are\nkept in $XDG_CACHE_HOME/facet, else ~/.cache/facet, which "
        "may be deleted at any time;\nFACET_CACHE=off keeps nothing.\n\n";
    for (const auto& row : tables::settings)
        if (row.rare)
            out += fmt::format("  {:<24} {}\n",
                               tables::flag_name(row.key) + (row.value.empty() ? "" : " ") +
                                   std::string(row.value),
                               row.help);
    return out;
}

std::string exit_codes() {
    std::string out = "Example: facet render a.glb || echo \"ended with $?\"\n\n";
    for (const auto& row : tables::exit_codes)
        out += fmt::format("  {:>3}  {:<16} {}\n", row.number, row.key, row.help);
    return out;
}

std::string brdf() {
    std::string out =
        "Example: facet brdf furnace --brdf lecture --roughness 0.1,0.5,1\n\n"
        "facet brdf eval --input GRID.csv   columns "
        "term,model,roughness,metallic,f0,n_dot_v,n_dot_l,phi; writes them\n"
        "                                   with value_r,value_g,value_b behind. term is one of D "
        "G V F specular diffuse\n"
        "                                   full; model is a value of --brdf with ; between its "
        "parts, or empty; phi is\n"
        "                                   the azimuth between view and light in degrees, 180 on "
        "the mirror side\n"
        "facet brdf albedo                  what the specular lobe reflects of light from "
        "everywhere; with --balance\n"
        "                                   reflected (that), transmitted (entered, and left again "
        "as diffuse light),\n"
        "                                   absorbed (the rest); they add up to 1\n"
        "facet brdf furnace                 what both lobes reflect of light from everywhere, and "
        "how far that is from 1\n"
        "facet brdf sample --count 1000     directions as the reference draws them: their density, "
        "value, and weight\n"
        "                                   value cos / density, whose mean is the albedo\n"
        "facet brdf plot -o lobe.svg        lobes in the plane of incidence, and D, F and G; "
        "several --brdf in one plot\n\n"
        "Base colour is white unless --base-color says otherwise. --via gl asks the shaders "
        "instead of C++.\n"
        "Terms, the first of each the default:\n";
    std::string_view slot;
    for (const tables::BrdfTerm& term : tables::brdf_terms) {
        const bool is_choice = std::ranges::any_of(
            tables::brdf_slots,
            [&](const tables::BrdfSlot& each) { return each.key == term.slot; });
        if (!is_choice || term.slot == "width") continue;
        std::string name(term.name);
        std::ranges::replace(name, '_', '-');
        out += fmt::format("  {:<14} {:<18} {}\n", term.slot == slot ? "" : term.slot, name,
                           term.notes.help);
        slot = term.slot;
    }
    return out + "  lecture, lecture-literal: the seed lecture's sets\n";
}

struct Topic {
    std::string_view name;
    std::string (*text)();
};
constexpr Topic topics[] = {
    {"lights", lights},   {"cameras", cameras}, {"quality", quality},      {"jobs", jobs},
    {"set", set},         {"studio", studio},   {"lessons", lessons},      {"aovs", aovs},
    {"brdf-terms", brdf}, {"more", more},       {"exit-codes", exit_codes}};

}  // namespace

base::Result<std::string> topic_help(const std::string& topic) {
    std::vector<std::string> names;
    for (const Topic& one : topics) {
        if (one.name == topic) return one.text();
        names.emplace_back(one.name);
    }
    return base::fail({.code = base::ErrorCode::usage,
                       .file = topic,
                       .what = "no such topic",
                       .remedy = base::suggestion(topic, names)});
}

}  // namespace facet::cli
