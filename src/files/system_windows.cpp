// SPDX-License-Identifier: MIT
#include <windows.h>

#include <algorithm>

#include "folder.hpp"
#include "pages.hpp"
#include "path.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;

// Sharing mode of all handles: others may do anything, as with POSIX.
constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

HANDLE handle_of(std::intptr_t number) { return reinterpret_cast<HANDLE>(number); }
HANDLE handle_of(const Descriptor& entry) { return handle_of(entry.number()); }

constexpr std::pair<DWORD, int> kReasons[] = {
    {ERROR_FILE_NOT_FOUND, ENOENT},      {ERROR_PATH_NOT_FOUND, ENOENT},
    {ERROR_INVALID_NAME, ENOENT},        {ERROR_BAD_PATHNAME, ENOENT},
    {ERROR_BAD_NETPATH, ENOENT},         {ERROR_BAD_NET_NAME, ENOENT},
    {ERROR_INVALID_DRIVE, ENOENT},       {ERROR_ACCESS_DENIED, EACCES},
    {ERROR_WRITE_PROTECT, EACCES},       {ERROR_DELETE_PENDING, EACCES},
    {ERROR_SHARING_VIOLATION, EBUSY},    {ERROR_FILE_EXISTS, EEXIST},
    {ERROR_ALREADY_EXISTS, EEXIST},      {ERROR_LOCK_VIOLATION, EWOULDBLOCK},
    {ERROR_IO_PENDING, EWOULDBLOCK},     {ERROR_DISK_FULL, ENOSPC},
    {ERROR_HANDLE_DISK_FULL, ENOSPC},    {ERROR_DIR_NOT_EMPTY, ENOTEMPTY},
    {ERROR_DIRECTORY, ENOTDIR},          {ERROR_FILENAME_EXCED_RANGE, ENAMETOOLONG},
    {ERROR_TOO_MANY_OPEN_FILES, EMFILE}, {ERROR_NOT_ENOUGH_MEMORY, ENOMEM},
    {ERROR_INVALID_FUNCTION, ENOTSUP},   {ERROR_NOT_SUPPORTED, ENOTSUP},
};

// errno of the last failed call.
int reason() {
  const DWORD error = GetLastError();
  for (const auto& [known, why] : kReasons) {
    if (known == error) return why;
  }
  return EIO;
}

int told(BOOL done) { return done ? 0 : reason(); }

// Calls again for a second while another program, such as one that looks for viruses, holds a file.
template <class Call>
int insist(Call call) {
  for (int tries = 40;; --tries) {
    const int why = told(call());
    if ((why != EACCES && why != EBUSY) || tries == 0) return why;
    Sleep(25);
  }
}

Descriptor open(const std::wstring& path, DWORD access, DWORD how, DWORD flags = 0,
                DWORD shared = kShared) {
  const HANDLE handle = CreateFileW(path.c_str(), access, shared, nullptr, how,
                                    FILE_FLAG_BACKUP_SEMANTICS | flags, nullptr);
  if (handle == INVALID_HANDLE_VALUE) errno = reason();
  return Descriptor(reinterpret_cast<std::intptr_t>(handle));
}

// Path of an open folder in one of the system's forms; empty if it has none.
std::wstring path_of(const Descriptor& folder, DWORD form) {
  std::wstring path(MAX_PATH, L'\0');
  for (;;) {
    const DWORD size = GetFinalPathNameByHandleW(handle_of(folder), path.data(),
                                                 static_cast<DWORD>(path.size()), form);
    const bool fits = size < path.size();
    path.resize(size);
    if (fits) return path;
  }
}

// Path of a name in an open folder. Empty, which every call refuses, if the folder has none.
std::wstring path_in(const Descriptor& folder, const std::string& name) {
  std::wstring path = path_of(folder, VOLUME_NAME_DOS);
  if (path.empty()) {
    // a disk without a letter, or that its driver has not announced
    path = path_of(folder, VOLUME_NAME_NT);
    if (path.empty()) return path;
    path = L"\\\\?\\GLOBALROOT" + path;
  }
  if (!path.ends_with(L'\\')) path += L'\\';
  path += to_path(name).wstring();
  // a short one without the prefix, by which names such as NUL and "a." would be files
  const bool has_letter = path.size() > 6 && path[5] == L':';
  return has_letter && path.size() < MAX_PATH ? path.substr(4) : path;
}

// Type of an open file or folder that is neither a pipe nor a device. Files of a cloud's folder are
// reparse points too, and no links.
fs::file_type type_on_disk(const Descriptor& entry) {
  FILE_ATTRIBUTE_TAG_INFO about{};
  if (!GetFileInformationByHandleEx(handle_of(entry), FileAttributeTagInfo, &about, sizeof about)) {
    return fs::file_type::not_found;
  }
  if ((about.FileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 &&
      IsReparseTagNameSurrogate(about.ReparseTag)) {
    return fs::file_type::symlink;
  }
  return (about.FileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? fs::file_type::directory
                                                                : fs::file_type::regular;
}

std::optional<BY_HANDLE_FILE_INFORMATION> information_of(const Descriptor& entry) {
  BY_HANDLE_FILE_INFORMATION information;
  if (!GetFileInformationByHandle(handle_of(entry), &information)) return std::nullopt;
  return information;
}

std::uint64_t whole(DWORD high, DWORD low) { return std::uint64_t{high} << 32 | low; }

DWORD piece(std::size_t size) {
  return static_cast<DWORD>(std::min<std::size_t>(size, std::size_t{1} << 30));
}

// Whether a folder is another machine's, which knows nothing of the locks here.
bool is_remote(const Descriptor& entry) {
  const std::wstring path = path_of(entry, VOLUME_NAME_DOS);
  return path.empty() || path.starts_with(L"\\\\?\\UNC\\") ||
         (path.size() > 6 && GetDriveTypeW(path.substr(4, 3).c_str()) == DRIVE_REMOTE);
}

}  // namespace

// Windows locks ranges of files, but no folders. So a folder's lock is a byte of one file that all
// users of the machine share, at an offset that the folder's number gives.
struct LockOf {
  static int release(const Descriptor& entry) {
    if (entry.lock_ == -1) return 0;
    return told(CloseHandle(handle_of(std::exchange(entry.lock_, -1))));
  }

  static int take(const Descriptor& entry, LockKind kind) {
    (void)release(entry);
    const auto information = information_of(entry);
    const auto shared = path_in_environment("ProgramData");
    if (!information || !shared || is_remote(entry)) return ENOTSUP;
    const std::uint64_t number = whole(information->nFileIndexHigh, information->nFileIndexLow);
    // of file systems that number nothing
    if (number == 0 || number == ~std::uint64_t{0}) return ENOTSUP;
    Descriptor locks = open((*shared / L"shigusa.lock").wstring(), GENERIC_READ, OPEN_ALWAYS, 0,
                            FILE_SHARE_READ | FILE_SHARE_WRITE);
    if (!locks) return ENOTSUP;
    OVERLAPPED place{};
    place.Offset = information->nFileIndexLow ^ information->dwVolumeSerialNumber;
    place.OffsetHigh = information->nFileIndexHigh & 0x7FFFFFFF;
    const DWORD how = kind == LockKind::alone ? LOCKFILE_EXCLUSIVE_LOCK : 0;
    if (!LockFileEx(handle_of(locks), how | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &place)) {
      return reason();
    }
    entry.lock_ = locks.release();
    return 0;
  }
};

int Descriptor::close() {
  (void)LockOf::release(*this);
  return number_ == -1 ? 0 : told(CloseHandle(handle_of(std::exchange(number_, -1))));
}

Descriptor open_to_read(const fs::path& path) {
  return open(path.wstring(), GENERIC_READ, OPEN_EXISTING);
}

int let_wait(const Descriptor&) { return 0; }

Descriptor open_to_write(const fs::path& path) {
  return open(path.wstring(), GENERIC_WRITE, OPEN_EXISTING);
}

int write_all(const Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    DWORD count = 0;
    if (!WriteFile(handle_of(file), bytes.data(), piece(bytes.size()), &count, nullptr)) {
      return reason();
    }
    bytes.remove_prefix(count);
  }
  return 0;
}

std::ptrdiff_t read_some(const Descriptor& file, char* block, std::size_t size) {
  DWORD count = 0;
  if (ReadFile(handle_of(file), block, piece(size), &count, nullptr)) return count;
  if (GetLastError() == ERROR_BROKEN_PIPE || GetLastError() == ERROR_HANDLE_EOF) return 0;
  errno = reason();
  if (errno == ENOTSUP) errno = EISDIR;
  return -1;
}

bool read_at(const Descriptor& file, std::uint64_t at, char* block, std::size_t size) {
  while (size > 0) {
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(at);
    place.OffsetHigh = static_cast<DWORD>(at >> 32);
    DWORD count = 0;
    if (!ReadFile(handle_of(file), block, piece(size), &count, &place) || count == 0) return false;
    block += count;
    at += count;
    size -= count;
  }
  return true;
}

int go_to(const Descriptor& file, std::uint64_t at) {
  LARGE_INTEGER to;
  to.QuadPart = static_cast<LONGLONG>(at);
  return told(SetFilePointerEx(handle_of(file), to, nullptr, FILE_BEGIN));
}

std::optional<std::uint64_t> go_to_end(const Descriptor& file) {
  LARGE_INTEGER end;
  if (SetFilePointerEx(handle_of(file), {}, &end, FILE_END)) {
    return static_cast<std::uint64_t>(end.QuadPart);
  }
  errno = reason();
  return std::nullopt;
}

Descriptor open_folder(const fs::path& path) {
  Descriptor folder = open(path.wstring(), GENERIC_READ, OPEN_EXISTING);
  if (!folder || type_of(folder) == fs::file_type::directory) return folder;
  errno = ENOTDIR;
  return {};
}

Descriptor open_entry(const Descriptor& folder, const std::string& name) {
  // not as a reparse point, as a file of a cloud's folder would stay where it is
  if (type_in(folder, name) != fs::file_type::symlink) {
    return open(path_in(folder, name), GENERIC_READ, OPEN_EXISTING);
  }
  errno = ELOOP;
  return {};
}

Descriptor create_in(const Descriptor& folder, const std::string& name) {
  return open(path_in(folder, name), GENERIC_READ | GENERIC_WRITE, CREATE_NEW);
}

std::vector<std::string> names_in(const Descriptor& folder) {
  std::vector<std::string> names;
  WIN32_FIND_DATAW found;
  const HANDLE search = FindFirstFileW(path_in(folder, "*").c_str(), &found);
  if (search == INVALID_HANDLE_VALUE) return names;
  do {
    const std::string name = to_utf8(found.cFileName);
    if (name != "." && name != "..") names.push_back(name);
  } while (FindNextFileW(search, &found));
  FindClose(search);
  return names;
}

fs::file_type type_of(const Descriptor& entry) {
  const DWORD type = entry ? GetFileType(handle_of(entry)) : FILE_TYPE_UNKNOWN;
  if (type == FILE_TYPE_PIPE) return fs::file_type::fifo;
  if (type == FILE_TYPE_CHAR) return fs::file_type::character;
  return type_on_disk(entry);
}

fs::file_type type_in(const Descriptor& folder, const std::string& name) {
  return type_on_disk(open(path_in(folder, name), FILE_READ_ATTRIBUTES, OPEN_EXISTING,
                           FILE_FLAG_OPEN_REPARSE_POINT));
}

bool is_named(const Descriptor& entry, const Descriptor& folder, const std::string& name) {
  const auto ours = information_of(entry);
  const auto named = information_of(open_entry(folder, name));
  return ours && named && ours->nFileIndexHigh == named->nFileIndexHigh &&
         ours->nFileIndexLow == named->nFileIndexLow;
}

bool older_than(const Descriptor& entry, std::chrono::seconds age) {
  constexpr std::uint64_t kTicks = 10'000'000;  // of a file's time in 1 s
  const auto information = information_of(entry);
  if (!information) return false;
  FILETIME now;
  GetSystemTimeAsFileTime(&now);
  const FILETIME& changed = information->ftLastWriteTime;
  return whole(changed.dwHighDateTime, changed.dwLowDateTime) +
             static_cast<std::uint64_t>(age.count()) * kTicks <
         whole(now.dwHighDateTime, now.dwLowDateTime);
}

int check_writable(const Descriptor& folder, const std::string& name) {
  const std::wstring path = path_in(folder, name);
  const DWORD attributes = GetFileAttributesW(path.c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES) return reason();
  if ((attributes & FILE_ATTRIBUTE_READONLY) != 0) return EACCES;
  const Descriptor file =
      open(path, GENERIC_WRITE | DELETE, OPEN_EXISTING, FILE_FLAG_OPEN_REPARSE_POINT);
  return file ? 0 : errno;
}

// For all who may use the folder around it.
int make_folder_in(const Descriptor& folder, const std::string& name) {
  return told(CreateDirectoryW(path_in(folder, name).c_str(), nullptr));
}

int remove_in(const Descriptor& folder, const std::string& name) {
  const std::wstring path = path_in(folder, name);
  return insist([&] { return DeleteFileW(path.c_str()); });
}

int remove_folder_in(const Descriptor& folder, const std::string& name) {
  const std::wstring path = path_in(folder, name);
  return insist([&] { return RemoveDirectoryW(path.c_str()); });
}

// The new file has the permissions that its folder gives.
int move_in(const Descriptor& from, const std::string& name, const Descriptor& folder,
            const std::string& to) {
  const std::wstring old = path_in(from, name);
  const std::wstring target = path_in(folder, to);
  return insist(
      [&] { return MoveFileExW(old.c_str(), target.c_str(), MOVEFILE_REPLACE_EXISTING); });
}

int settle(const Descriptor& entry) {
  // names of a folder cannot be flushed
  if (type_of(entry) == fs::file_type::directory) return 0;
  const int why = told(FlushFileBuffers(handle_of(entry)));
  return why == ENOTSUP ? 0 : why;
}

int lock_now(const Descriptor& entry, LockKind kind) { return LockOf::take(entry, kind); }

std::optional<fs::path> path_in_environment(const char* variable) {
  const wchar_t* value = _wgetenv(to_path(variable).c_str());
  if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
  return fs::path(value);
}

// Bytes that are no UTF-8 become replacement characters.
fs::path to_path(std::string_view text) {
  std::wstring wide(text.size(), L'\0');
  const int size = MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()),
                                       wide.data(), static_cast<int>(wide.size()));
  wide.resize(static_cast<std::size_t>(size));
  return wide;
}

std::string to_utf8(std::wstring_view text) {
  const int size = static_cast<int>(text.size());
  std::string bytes(3 * text.size(), '\0');
  bytes.resize(static_cast<std::size_t>(WideCharToMultiByte(
      CP_UTF8, 0, text.data(), size, bytes.data(), 3 * size, nullptr, nullptr)));
  return bytes;
}

void* take_pages(std::size_t bytes) {
  return VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
}

void give_pages(void* pages, std::size_t) noexcept { VirtualFree(pages, 0, MEM_RELEASE); }

}  // namespace shigusa
