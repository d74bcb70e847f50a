// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/messages/message_text.hpp"

namespace shigusa::messages {

// Sentences that others are made of.
inline constexpr std::array kWords{
    MessageText{"at_place", "{}: {}"},
    MessageText{"must_be_object", "must be an object {{ … }}"},
    MessageText{"must_be_number_in", "is {}; allowed are numbers from {:g} to {:g}"},
    MessageText{"allowed_is_one", "is {}; allowed is {}"},
    MessageText{"whole_numbers", "is {}; allowed are whole numbers from {} to {}"},
    MessageText{"must_be_text", "is {}; must be a text"},
    MessageText{"must_be_truth", "must be true or false"},
    MessageText{"must_be_texts", "must be a list of texts"},
    MessageText{"must_be_point", "is {}; must be three numbers [x, y, z] from {:g} to {:g}"},
    MessageText{"must_be_quaternion", "is {}; must be a unit quaternion [x, y, z, w]"},
    MessageText{"must_be_points",
                "must be a list of at most {} points [x, y, z], each number from {:g} to {:g}"},
    MessageText{"is_missing", "is missing"},
    MessageText{"must_be_list_of", "must be a list [ … ] of {}"},
    MessageText{"at_most", "are {}; allowed are {} at most"},
    MessageText{"whole_number_or", "must be a whole number from {}, or \"{}\""},
    MessageText{"unknown_name", "unknown {} '{}'. Known: {}"},
    MessageText{"unknown_name_near", "unknown {} '{}'; did you mean '{}'? Known: {}"},
    MessageText{"unknown_name_sides", "unknown {} '{}'; did you mean '{}' or '{}'? Known: {}"},
    MessageText{"values_most", "more than {} values"},
    MessageText{"objects_most", "more than {} objects in one list"},
    MessageText{"key_twice", "the key '{}' stands twice in one object"},
    MessageText{"members_most", "more than {} members in one object"},
};

}  // namespace shigusa::messages
