// One run of one scene from its beginning (or its checkpoint) to a finished record.
#pragma once

#include <functional>

#include "record/command_line.h"
#include "scene/scene.h"

/// Builds the world, simulates, writes command.record_path(). `stop_asked` is polled after every
/// step; a run that is asked to stop leaves a checkpoint and its unfinished record behind. Returns
/// the exit code: all_right, interrupted, numerical_trouble or not_written. After numerical trouble
/// the record is finished, marked as failed, and holds the snapshot "last good state"; after
/// anything else that stops a run, such as a full disk, it stays unfinished. Throws scene::BadScene
/// and std::runtime_error for what is wrong before the first step.
int run(const scene::Scene &, const record::CommandLine &, const std::function<bool()> &stop_asked);
