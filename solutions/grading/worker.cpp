#include "worker.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/random.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

#include "sleep.hpp"

namespace grading {
namespace {

using std::chrono::steady_clock;

constexpr int status_descriptor = 5;  // bubblewrap says there that it has come up
constexpr int patience = 10;          // what a worker may compute [s]
constexpr int little_patience = 1;    // after `timeouts` of them
constexpr int timeouts = 3;
constexpr int wall_factor = 6;  // a loaded machine is slow
constexpr auto glance = std::chrono::milliseconds(250);
constexpr int idle_glances = 8;  // after so many in which it sleeps it will not wake

std::string environment(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? "" : text;
}

/// Of this many workers it is known that they came to no end. A byte each in a file that is shared
/// by all cases of a submission: one endless loop must not cost ten seconds in each of a hundred
/// cases.
long known_timeouts() {
  struct stat file {};
  return stat(environment("TUMBLE_TIMEOUTS").c_str(), &file) == 0 ? file.st_size : 0;
}

/// What this worker may compute [s].
int allowed_seconds() {
  const int chosen = std::atoi(environment("TUMBLE_PATIENCE").c_str());
  if (known_timeouts() >= timeouts) return little_patience;
  return chosen > 0 ? chosen : patience;
}

void note_timeout() { std::ofstream(environment("TUMBLE_TIMEOUTS"), std::ios::app) << '.'; }

std::vector<std::string> command_line() {
  const std::string file = environment("TUMBLE_WORKER");
  std::ifstream lines(file);
  std::vector<std::string> arguments;
  for (std::string line; std::getline(lines, line);) arguments.push_back(line);
  if (arguments.empty() || access(arguments.front().c_str(), X_OK) != 0) {
    end_case("grader error: no program in the file TUMBLE_WORKER=" + file);
  }
  return arguments;
}

/// Both ends; the one that the worker gets is inherited.
struct Pipe {
  int read_end = -1;
  int write_end = -1;
};
Pipe new_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) end_case("grader error: no pipe");
  // Away from the numbers that the worker's own ends take.
  for (int& end : ends) {
    const int moved = fcntl(end, F_DUPFD_CLOEXEC, 10);
    close(end);
    if (moved < 0) end_case("grader error: no descriptor");
    end = moved;
  }
  return {ends[0], ends[1]};
}

/// In the child, before its program.
void redirect(const Pipe& requests, const Pipe& answers, const Pipe& status,
              const std::string& log) {
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  const int errors =
      log.empty() ? nowhere : open(log.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  dup2(requests.read_end, request_descriptor);
  dup2(answers.write_end, answer_descriptor);
  dup2(status.write_end, status_descriptor);
}

std::string fate_of_signal(int signal) {
  // SIGKILL follows where SIGXCPU is ignored.
  if (signal == SIGXCPU || signal == SIGKILL) return "time out";
  if (signal == SIGXFSZ) return "flood";
  const char* name = sigabbrev_np(signal);
  return std::string("crash SIG") + (name == nullptr ? "?" : name);
}

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 512> part{};
  fcntl(descriptor, F_SETFL, O_NONBLOCK);
  for (ssize_t n = 0; (n = read(descriptor, part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(n));
  }
  return text;
}

}  // namespace

Worker& Worker::the() {
  static Worker worker;
  return worker;
}

void Worker::start() {
  std::signal(SIGPIPE, SIG_IGN);
  std::vector<std::string> words = command_line();
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  patience_ = allowed_seconds();
  const auto limit = static_cast<rlim_t>(patience_);
  const rlimit cpu{limit, limit + 1};
  const std::string log = environment("TUMBLE_WORKER_LOG");
  const Pipe requests = new_pipe();
  const Pipe answers = new_pipe();
  const Pipe status = new_pipe();
  process_ = fork();
  if (process_ < 0) end_case("grader error: no process");
  if (process_ == 0) {
    redirect(requests, answers, status, log);
    setrlimit(RLIMIT_CPU, &cpu);
    // The seed stands in the environment of this process; the worker gets another one.
    std::array<char, 14> path{"PATH=/usr/bin"};
    const std::array<char*, 2> settings{path.data(), nullptr};
    execve(arguments[0], arguments.data(), settings.data());
    _exit(127);
  }
  close(requests.read_end);
  close(answers.write_end);
  close(status.write_end);
  requests_ = requests.write_end;
  answers_ = answers.read_end;
  status_ = status.read_end;
  fcntl(requests_, F_SETFL, O_NONBLOCK);
}

void Worker::wait(int descriptor, short event) {
  std::string sleep;
  for (int glances_asleep = 0; glances_asleep < idle_glances;) {
    const auto begun = steady_clock::now();
    pollfd what{descriptor, event, 0};
    if (poll(&what, 1, static_cast<int>(glance.count())) != 0) {
      waited_ += steady_clock::now() - begun;
      return;
    }
    waited_ += steady_clock::now() - begun;
    if (waited_ > std::chrono::seconds(wall_factor * patience_)) break;
    const std::string before = std::exchange(sleep, sleep_of(process_));
    glances_asleep = !sleep.empty() && sleep == before ? glances_asleep + 1 : 0;
  }
  note_timeout();
  end_case("time out");
}

void Worker::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(requests_, bytes.data(), bytes.size());
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN) {
      wait(requests_, POLLOUT);
    } else if (errno != EINTR) {
      report_death();
    }
  }
}

void Worker::receive(std::string& to) {
  static std::array<char, 1 << 16> part;
  wait(answers_, POLLIN);
  const ssize_t count = read(answers_, part.data(), part.size());
  if (count < 0 && errno == EINTR) return;
  if (count <= 0) report_death();
  to.append(part.data(), static_cast<std::size_t>(count));
}

Answer Worker::ask(std::uint32_t function, const std::string& arguments,
                   std::uint32_t answer_limit) {
  if (process_ == 0) start();
  RequestHead request;
  request.size = static_cast<std::uint32_t>(arguments.size());
  request.function = function;
  if (getrandom(&request.nonce, sizeof request.nonce, 0) != sizeof request.nonce) {
    end_case("grader error: no random bytes");
  }
  std::string whole(sizeof request, '\0');
  std::memcpy(whole.data(), &request, sizeof request);
  send(whole + arguments);

  Answer answer;
  std::string& bytes = answer.bytes;
  while (bytes.size() < sizeof answer.head) receive(bytes);
  std::memcpy(&answer.head, bytes.data(), sizeof answer.head);
  if (answer.head.nonce != request.nonce) end_case("malformed");
  if (answer.head.size > answer_limit) end_case("flood");
  const std::size_t wanted = sizeof answer.head + answer.head.size;
  while (bytes.size() < wanted) receive(bytes);
  if (bytes.size() > wanted) end_case("malformed");  // more than was asked for
  bytes.erase(0, sizeof answer.head);
  return answer;
}

void Worker::report_death() {
  int status = 0;
  const pid_t process = process_;
  close(requests_);  // a worker that only closed its end is ended by this
  for (int i = 0; i < 200 && process_ > 0; ++i) {
    if (waitpid(process, &status, WNOHANG) == process) process_ = 0;
    if (process_ > 0) usleep(5000);
  }
  if (process_ > 0) end_case("crash it ended its own pipe");
  const std::string box = read_all(status_);
  if (environment("TUMBLE_SANDBOX") == "bubblewrap" &&
      box.find("\"child-pid\"") == std::string::npos) {
    end_case("grader error: the sandbox did not come up");
  }
  const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  if (code <= 128 || code > 128 + SIGSYS) end_case("crash it ended the program");
  const std::string fate = fate_of_signal(code - 128);
  if (fate == "time out") note_timeout();
  end_case(fate);
}

void Worker::kill() {
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
  process_ = 0;
}

}  // namespace grading
