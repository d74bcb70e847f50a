// SPDX-License-Identifier: MIT
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::Not;

// `shigusa studio` as it runs, and what it answers on its port.
class Studio : public testing::Test {
 protected:
  void start(const std::string& folder) {
    child_ = start_shigusa({"studio", "--no-open", "--folder", folder}, {}, out_, err_);
    std::string line;
    for (char c = 0; read(out_.read_end, &c, 1) == 1 && c != '\n';) line += c;
    const std::string before = "http://127.0.0.1:";
    ASSERT_THAT(line, testing::StartsWith(before));
    port_ = std::stoi(line.substr(before.size()));
  }

  ~Studio() override {
    if (child_ > 0) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
    }
    close(out_.read_end);
    close(err_.read_end);
  }

  // The whole answer to a request for `path`, sent as `host`.
  [[nodiscard]] std::string get(const std::string& path, std::string host = {}) const {
    if (host.empty()) host = "127.0.0.1:" + std::to_string(port_);
    const int connection = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
    std::string answer;
    if (connect(connection, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
      const std::string request =
          "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n";
      (void)!write(connection, request.data(), request.size());
      char buffer[4096];
      for (ssize_t n = 0; (n = read(connection, buffer, sizeof buffer)) > 0;) {
        answer.append(buffer, static_cast<std::size_t>(n));
      }
    }
    close(connection);
    return answer;
  }

  WorkFolder work_;
  Channel out_{false};
  Channel err_{false};
  pid_t child_ = -1;
  int port_ = 0;
};

TEST_F(Studio, ServesThePageWithItsTypesAndAPolicy) {
  work_.put("page/index.html", "<!doctype html><title>studio</title>");
  work_.put("page/assets/engine.wasm", "wasm");
  work_.put("page/assets/main.js", "export {};");
  work_.put("secret.txt", "secret");
  start((work_.path() / "page").string());
  const std::string page = get("/");
  EXPECT_THAT(page, HasSubstr("200 OK"));
  EXPECT_THAT(page, HasSubstr("text/html"));
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy: default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("<title>studio</title>"));
  EXPECT_THAT(get("/assets/engine.wasm"), HasSubstr("application/wasm"));
  EXPECT_THAT(get("/assets/main.js"), HasSubstr("text/javascript"));
  EXPECT_THAT(get("/none.js"), HasSubstr("404"));
  for (const char* outside : {"/../secret.txt", "/%2e%2e/secret.txt", "/assets/../../secret.txt"}) {
    EXPECT_THAT(get(outside), Not(HasSubstr("\r\n\r\nsecret"))) << outside;
  }
  EXPECT_THAT(get("/", "page-of-somebody:80"), HasSubstr("421"));

  kill(child_, SIGTERM);
  int status = -1;
  waitpid(child_, &status, 0);
  child_ = -1;
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

TEST_F(Studio, TellsWhatItCannotServe) {
  const ProgramRun missing =
      run_shigusa({"studio", "--no-open", "--folder", (work_.path() / "none").string()});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("holds no index.html"));
  EXPECT_EQ(run_shigusa({"studio", "--port", "65536"}).exit_code, 2);
  work_.put("page/index.html", "x");
  start((work_.path() / "page").string());
  const ProgramRun taken = run_shigusa({"studio", "--no-open", "--port", std::to_string(port_),
                                        "--folder", (work_.path() / "page").string()});
  EXPECT_EQ(taken.exit_code, 2);
  EXPECT_THAT(taken.err, HasSubstr("port " + std::to_string(port_)));
}

}  // namespace
}  // namespace shigusa
