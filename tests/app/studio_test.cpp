// SPDX-License-Identifier: MIT
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// A connection to a port of this machine.
class Visitor {
 public:
  explicit Visitor(int port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
    // a test that waits for longer has failed
    const timeval patience{20, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  Visitor(Visitor&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}
  Visitor& operator=(Visitor&&) = delete;
  ~Visitor() {
    if (socket_ >= 0) close(socket_);
  }

  // False once the server does not listen any more.
  [[nodiscard]] bool say(std::string_view text) const {
    return send(socket_, text.data(), text.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(text.size());
  }

  // Everything up to the end of the connection; empty where it is broken off or none comes.
  [[nodiscard]] std::string hear() const {
    std::string answer;
    std::vector<char> block(1 << 16);
    ssize_t count = 0;
    while ((count = recv(socket_, block.data(), block.size(), 0)) > 0) {
      answer.append(block.data(), static_cast<std::size_t>(count));
    }
    return count == 0 ? answer : "";
  }

 private:
  int socket_;
};

// A running `shigusa studio`, and the answers on its port.
class Studio : public testing::Test {
 protected:
  void start(const std::string& folder) {
    child_ = start_shigusa({"studio", "--no-open", "--folder", folder}, {}, out_, err_);
    std::string line;
    for (char c = 0; read(out_.read_end, &c, 1) == 1 && c != '\n';) line += c;
    const std::string before = "http://127.0.0.1:";
    ASSERT_THAT(line, StartsWith(before));
    port_ = std::stoi(line.substr(before.size()));
  }

  // A page of a few bytes and an engine of many.
  void start_with_engine() {
    work_.put("page/index.html", "<title>studio</title>");
    work_.put("page/engine.wasm", std::string(kEngineBytes, 'e'));
    start((work_.path() / "page").string());
  }

  ~Studio() override {
    if (child_ > 0) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
    close(out_.read_end);
    close(err_.read_end);
  }

  [[nodiscard]] std::string own_host() const { return "127.0.0.1:" + std::to_string(port_); }

  // A request for `path`, with more lines of its head.
  [[nodiscard]] std::string request(const std::string& path, const std::string& more = {}) const {
    return "GET " + path + " HTTP/1.1\r\nHost: " + own_host() + "\r\n" + more + "\r\n";
  }

  [[nodiscard]] std::string answer_to(const std::string& text) const {
    const Visitor visitor(port_);
    EXPECT_TRUE(visitor.say(text));
    return visitor.hear();
  }
  [[nodiscard]] std::string get(const std::string& path) const { return answer_to(request(path)); }

  // kB that the server has held at most
  [[nodiscard]] long most_memory() const {
    std::ifstream status("/proc/" + std::to_string(child_) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("VmHWM:")) return std::stol(line.substr(6));
    }
    ADD_FAILURE() << "the kernel does not tell";
    return 0;
  }

  // True if the server ends well on request.
  bool ends() {
    kill(child_, SIGTERM);
    int status = -1;
    waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  static constexpr std::size_t kEngineBytes = 3'000'000;
  // More than it takes to answer anything of the page, and far less than a copy for each of the
  // askers in these tests.
  static constexpr long kLittleMemory = 8'000;  // kB
  WorkFolder work_;
  Channel out_{false};
  Channel err_{false};
  pid_t child_ = -1;
  int port_ = 0;
};

TEST_F(Studio, ServesThePageWithItsTypesAndAPolicy) {
  work_.put("page/index.html", "<!doctype html><title>studio</title>");
  work_.put("page/assets/engine.wasm", "wasm");
  work_.put("page/assets/starts.tsv", "table");
  work_.put("page/assets/main.js", "export {};");
  start((work_.path() / "page").string());
  const std::string page = get("/");
  EXPECT_THAT(page, StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(page, HasSubstr("text/html"));
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy: default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("\r\n\r\n<!doctype html><title>studio</title>"));
  EXPECT_EQ(get("/index.html?lang=ja"), page);
  EXPECT_THAT(get("/assets/engine.wasm"), HasSubstr("application/wasm"));
  EXPECT_THAT(get("/assets/starts.tsv"), HasSubstr("text/tab-separated-values"));
  EXPECT_THAT(get("/assets/main.js"), HasSubstr("text/javascript"));
  EXPECT_THAT(get("/none.js"), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(get("/assets"), StartsWith("HTTP/1.1 404 "));
}

TEST_F(Studio, FilesNamedByWhatTheyHoldAreKeptByBrowsersAndThePageIsAskedForAgain) {
  work_.put("page/index.html", "<!doctype html><title>studio</title>");
  work_.put("page/favicon.svg", "<svg/>");
  work_.put("page/assets/main-Hcia2ljg.js", "export {};");
  start((work_.path() / "page").string());
  EXPECT_THAT(get("/assets/main-Hcia2ljg.js"),
              HasSubstr("Cache-Control: max-age=31536000, immutable\r\n"));
  for (const char* path : {"/", "/favicon.svg", "/assets/none.js"}) {
    EXPECT_THAT(get(path), HasSubstr("Cache-Control: no-cache\r\n"));
  }
}

TEST_F(Studio, TellsOfAFileWithoutSendingIt) {
  start_with_engine();
  const std::string head =
      answer_to("HEAD /engine.wasm HTTP/1.1\r\nHost: " + own_host() + "\r\n\r\n");
  EXPECT_THAT(head, StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(head, HasSubstr("Content-Length: " + std::to_string(kEngineBytes) + "\r\n"));
  EXPECT_THAT(head, testing::EndsWith("\r\n\r\n"));
}

TEST_F(Studio, AnswersNobodyWhoCallsItByAnotherName) {
  start_with_engine();
  const std::string name = ":" + std::to_string(port_) + "\r\n";
  for (const std::string& head :
       {std::string("Host: page-of-somebody:80\r\n"), std::string(),
        "Host: page-of-somebody" + name, "Host: localhost" + name + "Host: page-of-somebody" + name,
        "X-Host: localhost" + name}) {
    const std::string answer = answer_to("GET / HTTP/1.1\r\n" + head + "\r\n");
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 421 ")) << head;
    EXPECT_THAT(answer, Not(HasSubstr("<title>"))) << head;
  }
  EXPECT_THAT(answer_to("GET / HTTP/1.1\r\nhost: localhost" + name + "\r\n"),
              StartsWith("HTTP/1.1 200 OK\r\n"));
}

TEST_F(Studio, RefusesWhatIsNoRequestForAFile) {
  start_with_engine();
  const std::string rest = "\r\nHost: " + own_host() + "\r\n\r\n";
  const struct {
    std::string line;
    const char* status;
  } cases[] = {{"POST / HTTP/1.1", "405"},
               {"DELETE /index.html HTTP/1.1", "405"},
               {"GET /", "400"},
               {"GET / HTTP/1.1 ", "400"},
               {"GET / HTTP/2.0", "505"},
               {"GET / FTP/1.1", "400"},
               {"", "400"},
               {std::string("\0\x16\x03 \xFF HTTP/1.1", 15), "400"},
               {"GET index.html HTTP/1.1", "404"},
               {std::string("GET /\0.html HTTP/1.1", 20), "200"},
               {std::string("GET /in\0dex.html HTTP/1.1", 25), "404"}};
  for (const auto& each : cases) {
    EXPECT_THAT(answer_to(each.line + rest), StartsWith(std::string("HTTP/1.1 ") + each.status))
        << each.line;
  }
}

TEST_F(Studio, GivesNothingFromOutsideItsFolder) {
  work_.put("secret.txt", "secret");
  work_.put("page/index.html", "<title>studio</title>");
  work_.put("page/later.txt", "first");
  const std::filesystem::path page = work_.path() / "page";
  std::filesystem::create_symlink("../secret.txt", page / "file.txt");
  std::filesystem::create_directory_symlink("..", page / "folder");
  start(page.string());
  // a link that is laid while the page is served
  std::filesystem::remove(page / "later.txt");
  std::filesystem::create_symlink("../secret.txt", page / "later.txt");
  for (const char* path : {"/../secret.txt", "/%2e%2e/secret.txt", "/assets/../../secret.txt",
                           "//../secret.txt", "/file.txt", "/folder/secret.txt", "/later.txt"}) {
    EXPECT_THAT(get(path), Not(HasSubstr("secret"))) << path;
  }
}

TEST_F(Studio, RangesOfAFileTakeNoMemory) {
  start_with_engine();
  const long before = most_memory();
  std::string ranges = "Range: bytes=0-";
  for (int k = 1; k < 500; ++k) ranges += ",0-";
  const std::string answer = answer_to(request("/engine.wasm", ranges + "\r\n"));
  EXPECT_THAT(answer.substr(0, 30), StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_LT(answer.size(), kEngineBytes + 4096);
  EXPECT_LT(most_memory() - before, kLittleMemory);
}

TEST_F(Studio, ARequestWithoutAnEndIsRefused) {
  start_with_engine();
  const long before = most_memory();
  const std::string much(1 << 20, 'a');
  std::string lines;
  for (int k = 0; k < 20'000; ++k) lines += "X-" + std::to_string(k) + ": a\r\n";
  for (const std::string& endless : {much, "GET / HTTP/1.1\r\n" + lines}) {
    const Visitor visitor(port_);
    for (int k = 0; k < 100 && visitor.say(endless); ++k) {
    }
  }
  EXPECT_LT(most_memory() - before, kLittleMemory);
  // one that is only somewhat too long hears why
  EXPECT_THAT(answer_to(request("/" + std::string(20'000, 'a'))), StartsWith("HTTP/1.1 414 "));
  EXPECT_THAT(answer_to(request("/", "X: " + std::string(20'000, 'a') + "\r\n")),
              StartsWith("HTTP/1.1 431 "));
}

TEST_F(Studio, APageLoadsWhileHundredsOfConnectionsStayOpen) {
  start_with_engine();
  const long before = most_memory();
  std::vector<Visitor> others;
  for (int k = 0; k < 400; ++k) {
    const Visitor& other = others.emplace_back(port_);
    // some trickle, and some ask for much that they do not take
    (void)other.say(k % 2 == 0 ? "G" : request("/engine.wasm"));
  }
  for (int round = 0; round < 3; ++round) {
    for (std::size_t k = 0; k < others.size(); k += 2) (void)others[k].say("E");
    const auto asked = std::chrono::steady_clock::now();
    EXPECT_THAT(get("/"), HasSubstr("<title>studio</title>"));
    EXPECT_EQ(get("/engine.wasm").size() / kEngineBytes, 1U);
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(5));
  }
  EXPECT_LT(most_memory() - before, kLittleMemory);
  EXPECT_TRUE(ends());
}

TEST_F(Studio, WhoSendsNoRequestIsNotWaitedForLong) {
  start_with_engine();
  const Visitor silent(port_);
  const Visitor slow(port_);
  ASSERT_TRUE(slow.say("GET / HT"));
  const auto came = std::chrono::steady_clock::now();
  EXPECT_EQ(silent.hear(), "");
  EXPECT_EQ(slow.hear(), "");
  EXPECT_LT(std::chrono::steady_clock::now() - came, std::chrono::seconds(15));
}

TEST_F(Studio, TellsWhatItCannotServe) {
  const auto refused = [](const std::string& folder) {
    const ProgramRun run = run_shigusa({"studio", "--no-open", "--folder", folder});
    EXPECT_EQ(run.exit_code, 2) << folder;
    return run.err;
  };
  EXPECT_THAT(refused((work_.path() / "none").string()), HasSubstr("No such file"));
  EXPECT_EQ(run_shigusa({"studio", "--port", "65536"}).exit_code, 2);
  work_.put("page/index.html", "x");
  start((work_.path() / "page").string());
  const ProgramRun taken = run_shigusa({"studio", "--no-open", "--port", std::to_string(port_),
                                        "--folder", (work_.path() / "page").string()});
  EXPECT_EQ(taken.exit_code, 2);
  EXPECT_THAT(taken.err, HasSubstr("port " + std::to_string(port_)));

  // a folder given by mistake
  work_.put("home/index.html", "x");
  std::filesystem::create_symlink("../page/index.html", work_.path() / "home/link.html");
  work_.put("home/film.mkv", "");
  std::filesystem::resize_file(work_.path() / "home/film.mkv", std::uintmax_t{1} << 30);
  EXPECT_THAT(refused((work_.path() / "home").string()), HasSubstr("more than"));
  work_.put("linked/other.html", "x");
  std::filesystem::create_symlink("other.html", work_.path() / "linked/index.html");
  EXPECT_THAT(refused((work_.path() / "linked").string()), HasSubstr("holds no index.html"));
}

}  // namespace
}  // namespace shigusa
