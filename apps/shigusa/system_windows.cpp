// SPDX-License-Identifier: MIT
// Calls of Windows: streams, arguments, Ctrl-C.
#include "commands.hpp"
#include "files/path.hpp"
// after ours, as it defines words such as near
#include <fcntl.h>
#include <io.h>
#include <windows.h>
// after windows.h
#include <shellapi.h>

#include <atomic>
#include <cstdlib>

namespace shigusa::app {
namespace {

std::atomic<bool> interrupt_flag{false};
UINT code_page = 0;  // of the console before the program
HANDLE main_thread = nullptr;

// A console keeps its code page after the program.
void restore_console() { SetConsoleOutputCP(code_page); }

// Called on a thread of its own.
BOOL WINAPI on_interrupt(DWORD) {
  if (interrupt_flag.exchange(true)) {
    // a second Ctrl-C gives up waiting for the best motion so far
    restore_console();
    TerminateProcess(GetCurrentProcess(), 130);
  }
  // a read of the standard input that waits
  CancelSynchronousIo(main_thread);
  return TRUE;
}

// Whether a read of the standard input would not wait.
bool has_input(HANDLE input) {
  const DWORD type = GetFileType(input);
  if (type == FILE_TYPE_DISK) return true;
  DWORD bytes = 0;
  // an ended pipe is read to learn so; a console is only read when asked to wait
  return type == FILE_TYPE_PIPE &&
         (!PeekNamedPipe(input, nullptr, 0, nullptr, &bytes, nullptr) || bytes > 0);
}

}  // namespace

void open_standard_streams() {
  for (const int stream : {0, 1, 2}) {
    if (_setmode(stream, _O_BINARY) >= 0) continue;
    // this takes the lowest free number; writing to a read-only descriptor fails
    (void)_wopen(L"NUL", stream == 2 ? _O_WRONLY : _O_RDONLY);
  }
  code_page = GetConsoleOutputCP();
  SetConsoleOutputCP(CP_UTF8);
  std::atexit(restore_console);
  // escape sequences of the progress line
  const HANDLE console = GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  if (GetConsoleMode(console, &mode)) {
    SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  }
}

char** utf8_arguments(int& count, char** arguments) {
  static std::vector<std::string> texts;
  static std::vector<char*> pointers;
  wchar_t** const wide = CommandLineToArgvW(GetCommandLineW(), &count);
  if (wide == nullptr) return arguments;
  for (int k = 0; k < count; ++k) texts.push_back(to_utf8(wide[k]));
  LocalFree(wide);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers.data();
}

bool InputLines::read_block(bool wait) {
  const HANDLE input = GetStdHandle(STD_INPUT_HANDLE);
  if (ended_ || interrupt_flag || (!wait && !has_input(input))) return false;
  constexpr DWORD kBlock = 1 << 16;
  block_.resize(kBlock);
  DWORD count = 0;
  ended_ = !ReadFile(input, block_.data(), kBlock, &count, nullptr) || count == 0;
  block_.resize(count);
  used_ = 0;
  return !ended_;
}

bool is_terminal() {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

void catch_interrupts() {
  const HANDLE self = GetCurrentProcess();
  DuplicateHandle(self, GetCurrentThread(), self, &main_thread, 0, FALSE, DUPLICATE_SAME_ACCESS);
  SetConsoleCtrlHandler(on_interrupt, TRUE);
}

const std::atomic<bool>& interrupted() { return interrupt_flag; }

}  // namespace shigusa::app
