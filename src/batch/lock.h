// Locks that keep two runs of one job apart, on one machine or several.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/result.h"
#include "batch/job.h"

#include <chrono>
#include <filesystem>
#include <vector>

namespace facet::batch {

/// Holds a shard of a job for as long as this lives; the system lets go of it when the process
/// ends, however it does. Shards of one count share the job; shards of another count, or the same
/// shard, do not.
class ShardLock {
public:
    /// `folder`: of the job's state; it exists. Waits up to `patience` for others to let go.
    /// Errors: temporary (locked, by whom), input_invalid (the folder cannot be written).
    [[nodiscard]] static base::Result<ShardLock> take(const std::filesystem::path& folder,
                                                      const Shard& shard,
                                                      std::chrono::milliseconds patience,
                                                      base::Warnings& warnings);
    ~ShardLock();
    ShardLock(ShardLock&& other) noexcept = default;
    ShardLock& operator=(ShardLock&& other) noexcept = default;

private:
    ShardLock() = default;
    std::vector<int> files_;
    std::filesystem::path owned_;  ///< where the file system has no locks: goes with this
};

}  // namespace facet::batch
