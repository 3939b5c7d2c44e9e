// facet help: a command's page, or a topic's.
// SPDX-License-Identifier: MIT
#include "cli/dispatch.h"
#include "cli/flags.h"
#include "cli/help.h"
#include "cli/pages.h"

#include <memory>

namespace facet::cli {
namespace {

base::Result<Exit> run_help(const std::string& topic, Io& io) {
    if (topic.empty()) {
        io.print(
            "Topics: lights cameras set aovs brdf-terms studio lessons more exit-codes, and "
            "every "
            "command; "
            "facet --help lists "
            "those.");
        return Exit::done;
    }
    const std::vector<NamedCommand> commands = declare_commands();
    std::string text;
    if (topic == "man-page") text = man_page(commands);  // these two are for cmake/install.cmake
    if (topic == "bash-completion") text = bash_completion(commands);
    for (const NamedCommand& command : commands)
        if (command.name == topic) text = command_help(command);
    if (text.empty()) {
        auto page = topic_help(topic);
        if (!page) return tl::unexpected(page.error());
        text = std::move(*page);
    }
    if (text.ends_with('\n')) text.pop_back();
    io.print(text);
    return Exit::done;
}

}  // namespace

void add_help(Declaration& command) {
    auto topic = std::make_shared<std::string>();
    command.flags.push_back(
        {"TOPIC", topic.get(), "", "",
         "a command, or lights cameras set aovs brdf-terms studio lessons more exit-codes"});
    command.job = [topic](Io& io) { return run_help(*topic, io); };
}

}  // namespace facet::cli
