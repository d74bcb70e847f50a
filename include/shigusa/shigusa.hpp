// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body_build.hpp>
#include <shigusa/body_model.hpp>
#include <shigusa/bvh.hpp>
#include <shigusa/character.hpp>
#include <shigusa/criteria.hpp>
#include <shigusa/edit.hpp>
#include <shigusa/export.hpp>
#include <shigusa/facts.hpp>
#include <shigusa/field.hpp>
#include <shigusa/file.hpp>
#include <shigusa/file_format.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/human_body.hpp>
#include <shigusa/joint_place.hpp>
#include <shigusa/kinematics.hpp>
#include <shigusa/landmarks.hpp>
#include <shigusa/layered_settings.hpp>
#include <shigusa/limb_cache.hpp>
#include <shigusa/mat3.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/motion_measures.hpp>
#include <shigusa/motion_page.hpp>
#include <shigusa/parallel.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/progress.hpp>
#include <shigusa/quat.hpp>
#include <shigusa/random.hpp>
#include <shigusa/request.hpp>
#include <shigusa/result.hpp>
#include <shigusa/result_file.hpp>
#include <shigusa/result_words.hpp>
#include <shigusa/scalar.hpp>
#include <shigusa/score_clip.hpp>
#include <shigusa/search.hpp>
#include <shigusa/skeleton.hpp>
#include <shigusa/strip_figure.hpp>
#include <shigusa/task.hpp>
#include <shigusa/task_file.hpp>
#include <shigusa/transform.hpp>
#include <shigusa/vec3.hpp>
#include <shigusa/verdict.hpp>
#include <shigusa/version.hpp>
#include <shigusa/words.hpp>

/// Natural whole-body motion from the goals of hands and feet. A BodyModel with Goals makes a Task;
/// generate() finds Candidates for it, and write_result() keeps them as files. Metres, kilograms,
/// seconds and radians everywhere; the world has +Y up, and a person faces +Z with the left towards
/// +X.
namespace shigusa {}
