// SPDX-License-Identifier: MIT
#pragma once

/// First number of the library's version. CMake reads all three here.
#define SHIGUSA_VERSION_MAJOR 0
/// The second: below 1.0 another one may have another interface.
#define SHIGUSA_VERSION_MINOR 1
/// The third: another one has the same interface.
#define SHIGUSA_VERSION_PATCH 0

/// Numbers as the text of a version.
#define SHIGUSA_QUOTE_VERSION(major, minor, patch) #major "." #minor "." #patch
/// The same of macros.
#define SHIGUSA_SPELL_VERSION(major, minor, patch) SHIGUSA_QUOTE_VERSION(major, minor, patch)
/// The version as text: "0.1.0".
#define SHIGUSA_VERSION \
  SHIGUSA_SPELL_VERSION(SHIGUSA_VERSION_MAJOR, SHIGUSA_VERSION_MINOR, SHIGUSA_VERSION_PATCH)
