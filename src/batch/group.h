// One entry of a job's items: its members over the defaults, as a product of axes.
// SPDX-License-Identifier: MIT
#pragma once

#include "batch/job_file.h"
#include "batch/job_paths.h"
#include "batch/job_values.h"

#include <string>
#include <vector>

namespace facet::batch {

class GroupReader {
public:
    struct Inputs {
        Job& job;
        const JobOptions& options;
        JobProblems& problems;
        const Json& defaults;
        const Json* output;  ///< of the whole job; may be null
    };
    explicit GroupReader(const Inputs& in)
        : in_(in), paths_(in.job.folder, in.options.settings.allow_read) {}

    /// Appends a group to the job, or what is wrong with it to the problems.
    void read(const Json& item, const std::string& pointer);

private:
    struct Members;  ///< what an item has, over the defaults
    void collect(const Json& object, const std::string& pointer, Members& out);
    void collect_sets(const Json& paths, const std::string& pointer, Members& out);
    [[nodiscard]] std::vector<std::string> known_keys() const;
    void put(const Given& given, Group& group);
    void put_one(const Given& given, Json value, Group& group);
    void put_axis(Axis axis, Group& group);
    /// The group with an axis of frames; a group a scene where each has as many as it takes. None,
    /// and a problem, where they make no sense.
    [[nodiscard]] std::vector<Group> with_frames(const Given& given, Group group);
    [[nodiscard]] std::vector<Group> with_animation(const Given& given, Group group);
    static void add_frame_axis(const Given& given, Group& group);
    void add_group(Group group, const std::string& pointer);
    void name_outputs(const Members& members, const std::string& pointer, Group& group);
    void check(const Members& members, const Group& group, const std::string& pointer);
    void keep(base::Error error, const std::string& pointer);

    Inputs in_;
    JobPaths paths_;
};

/// Whether settings make sense, as far as that can be known without the scene. Errors: usage, with
/// the flag as `file`, or the path of --set as `where`.
[[nodiscard]] base::Status check_settings(const tables::Settings& settings,
                                          const base::Limits& limits);

}  // namespace facet::batch
