// SPDX-License-Identifier: MIT
// Completion scripts for shells, generated from the manual.
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>

#include "manual.hpp"

namespace shigusa::app {
namespace {

using Texts = std::vector<std::string>;

// A text in single quotes for a shell of the Bourne family.
std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : text) inside += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return "'" + inside + "'";
}

// Command name without the program's: "dataset merge" for "shigusa dataset merge"; empty for the
// program.
std::string below_program(const CommandManual& command) {
  const std::size_t blank = command.path.find(' ');
  return blank == std::string::npos ? "" : command.path.substr(blank + 1);
}

void each_option(const CommandManual& command, const auto& visit) {
  for (const OptionGroupManual& group : command.groups) {
    for (const OptionManual& option : group.options) visit(option);
  }
}

Texts option_names(const CommandManual& command) {
  Texts names;
  each_option(command, [&names](const OptionManual& option) {
    if (!option.argument) names.push_back(option.name);
  });
  return names;
}

Texts command_words(const CommandManual& command) {
  Texts words;
  for (const CommandManual& below : command.commands) words.push_back(below.name());
  return words;
}

// Prefixes of a value "EFFECTOR=X,Y,Z", each with its sign: "right_hand=". Effectors are those of
// the default body.
Texts begun_values(const OptionManual& option) {
  Texts begun;
  if (option.form.starts_with("EFFECTOR=")) {
    const BodyModel body = human_body().body;
    for (int e = 0; e < body.effector_count(); ++e) begun.push_back(body.effector(e).name + "=");
  } else if (option.form.starts_with("HAND=")) {
    begun = {"left_hand=", "right_hand="};
  } else if (option.form.starts_with("BONE=")) {
    for (int b = 0; b < kHumanoidBoneCount; ++b) {
      begun.push_back(std::string(humanoid_bone_name(static_cast<HumanoidBone>(b))) + "=");
    }
  }
  return begun;
}

// All values, or their prefixes.
Texts offered(const OptionManual& option) {
  Texts words = words_of(option);
  const Texts begun = begun_values(option);
  words.insert(words.end(), begun.begin(), begun.end());
  return words;
}

// Cases for the value after an option, or for arguments, in bash.
std::string bash_value(const OptionManual& option) {
  std::string made;
  const Texts words = offered(option);
  if (!words.empty()) made += fmt::format(" words='{}'", fmt::join(words, " "));
  if (takes_file(option)) {
    made += " paths=file";
  } else if (takes_folder(option)) {
    made += " paths=folder";
  }
  return made.empty() ? " :" : made;
}

std::string bash_cases(const CommandManual& command) {
  std::string text;
  const std::string path = below_program(command);
  std::string arguments;
  each_option(command, [&](const OptionManual& option) {
    if (option.argument) {
      arguments += bash_value(option);
    } else if (!option.form.empty()) {
      text += fmt::format("    '{}|{}')\n     {} ;;\n", path, option.name, bash_value(option));
    }
  });
  Texts words = command_words(command);
  if (!words.empty()) arguments += fmt::format(" words=\"$words {}\"", fmt::join(words, " "));
  text += fmt::format("    '{}|'*)\n      options='{}'\n     {} ;;\n", path,
                      fmt::join(option_names(command), " "), arguments.empty() ? " :" : arguments);
  return text;
}

// An option for zsh's _arguments: '*--goal=[line]:FORM:action'.
std::string zsh_action(const OptionManual& option) {
  const Texts words = offered(option);
  if (words.empty())
    return takes_file(option) ? "_files" : takes_folder(option) ? "_files -/" : " ";
  const std::string all = fmt::format("{}", fmt::join(words, " "));
  // no blank follows "right_hand="
  const std::string add = begun_values(option).empty() ? "" : "-S \"\" ";
  if (takes_file(option)) return fmt::format("{{compadd {}-- {}; _files}}", add, all);
  return add.empty() ? "(" + all + ")" : fmt::format("{{compadd {}-- {}}}", add, all);
}
std::string zsh_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == ':' || c == '[' || c == ']' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}
std::string zsh_option(const OptionManual& option) {
  if (option.argument) {
    return fmt::format("{}:{}:{}", option.repeatable ? "*" : ":", zsh_text(option.name),
                       zsh_action(option));
  }
  std::string text = option.repeatable ? "*" : "";
  text += option.name + (option.form.empty() ? "" : "=") + "[" + zsh_text(option.brief) + "]";
  if (!option.form.empty()) text += ":" + zsh_text(option.form) + ":" + zsh_action(option);
  return text;
}
// Name of a command's function, "_shigusa_dataset_merge".
std::string zsh_name(const CommandManual& command) {
  std::string name = "_" + command.path;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}
std::string zsh_function(const CommandManual& command) {
  std::string text = zsh_name(command) + "() {\n";
  std::string calls;
  if (!command.commands.empty()) {
    text += "  local -a commands=(\n";
    for (const CommandManual& below : command.commands) {
      text += "    " + quoted(below.name() + ":" + zsh_text(below.brief)) + "\n";
      calls += fmt::format("    {}) shift words; (( CURRENT-- )); {}; return ;;\n", below.name(),
                           zsh_name(below));
    }
    text += "  )\n";
    text += fmt::format("  (( CURRENT > 2 )) && case $words[2] in\n{}  esac\n", calls);
    text += "  (( CURRENT == 2 )) && _describe command commands\n";
  }
  text += "  _arguments";
  each_option(command, [&text](const OptionManual& option) {
    text += " \\\n    " + quoted(zsh_option(option));
  });
  return text + "\n}\n";
}

std::string fish_quoted(const std::string& text) {
  std::string inside;
  for (const char c : text)
    inside += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return "'" + inside + "'";
}
std::string fish_option(const std::string& condition, const OptionManual& option) {
  std::string text = "complete -c shigusa -n " + condition;
  const Texts words = offered(option);
  const bool paths = takes_file(option) || takes_folder(option);
  const std::string folders =
      takes_folder(option) && !takes_file(option) ? "(__fish_complete_directories)" : "";
  if (!option.argument) {
    text += " -l " + option.name.substr(2) + " -d " + fish_quoted(option.brief);
    if (!option.form.empty()) text += paths && folders.empty() ? " -rF" : " -x";
  } else if (takes_file(option)) {
    text += " -F";
  }
  const std::string choices = fmt::format("{}", fmt::join(words, " ")) + folders;
  return text + (choices.empty() ? "" : " -a " + fish_quoted(choices)) + "\n";
}

}  // namespace

std::string bash_completion(const CommandManual& program) {
  std::string paths;
  std::string cases;
  for (const CommandManual* command : all_commands(program)) {
    if (command != &program) paths += (paths.empty() ? "'" : "|'") + below_program(*command) + "'";
    cases += bash_cases(*command);
  }
  return fmt::format(
      R"(# Completion of shigusa in bash; `shigusa completion bash` prints it.
_shigusa() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
  local command= next= i options= words= paths=
  for ((i = 1; i < COMP_CWORD; ++i)); do
    next="${{command:+$command }}${{COMP_WORDS[i]}}"
    case $next in
      {}) command=$next ;;
    esac
  done
  COMPREPLY=()
  # bash takes the sign of --option=value for a word, and that of right_hand=-0.2,1.1,0.4
  if [ "$word" = = ]; then
    word=
    [[ $before = -* ]] || return 0
  elif [ "$before" = = ]; then
    before=${{COMP_WORDS[COMP_CWORD - 2]}}
    [[ $before = -* ]] || return 0
  fi
  [[ $before = -* ]] || before=
  case "$command|$before" in
{}  esac
  case $word in
    -*) words="$options" paths= ;;
  esac
  [ -z "$words" ] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  # no blank comes after right_hand=
  [[ "${{COMPREPLY[0]-}}" != *= ]] || compopt -o nospace
  case $paths in
    file) compopt -o filenames; mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -f -- "$word") ;;
    folder) compopt -o filenames; mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -d -- "$word") ;;
  esac
}}
complete -F _shigusa shigusa
)",
      paths, cases);
}

std::string zsh_completion(const CommandManual& program) {
  std::string text =
      "#compdef shigusa\n# Completion of shigusa in zsh; `shigusa completion zsh` prints it.\n";
  for (const CommandManual* command : all_commands(program)) text += zsh_function(*command);
  return text + "_shigusa \"$@\"\n";
}

std::string fish_completion(const CommandManual& program) {
  std::string paths;
  std::string lines;
  for (const CommandManual* command : all_commands(program)) {
    const std::string path = below_program(*command);
    if (!path.empty()) paths += " " + fish_quoted(path);
    const std::string condition = fish_quoted("__shigusa_is \"" + path + "\"");
    for (const CommandManual& below : command->commands) {
      lines += fmt::format("complete -c shigusa -n {} -a {} -d {}\n", condition, below.name(),
                           fish_quoted(below.brief));
    }
    each_option(*command,
                [&](const OptionManual& option) { lines += fish_option(condition, option); });
  }
  return fmt::format(R"(# Completion of shigusa in fish; `shigusa completion fish` prints it.
function __shigusa_is
  set -l command
  for word in (commandline -opc)[2..-1]
    set -l next (string trim -- "$command $word")
    contains -- $next{} && set command $next
  end
  test "$command" = "$argv[1]"
end
complete -c shigusa -f
{})",
                     paths, lines);
}

}  // namespace shigusa::app
