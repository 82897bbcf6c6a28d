// SPDX-License-Identifier: Apache-2.0
// The whole server, with clients that open its terminal as a serial port.
#include "device/server.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <thread>

#include "responder.hpp"

namespace rung::device {
namespace {

using Bytes = std::vector<std::uint8_t>;
namespace fs = std::filesystem;

const Bytes kRequest{1, 3, 0, 0, 0, 1, 0x84, 0x0A};
const Bytes kReply{1, 3, 2, 0, 0, 0xB8, 0x44};

// A serial port as clients open it.
class Port {
 public:
  explicit Port(const std::string& name) : port_(::open(name.c_str(), O_RDWR | O_NOCTTY)) {
    EXPECT_GE(port_, 0) << name;
  }
  ~Port() { ::close(port_); }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  int descriptor() const { return port_; }
  void send(const Bytes& bytes) const {
    EXPECT_EQ(::write(port_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  // `count` bytes, or those that came before nothing came for `ms`.
  Bytes receive(std::size_t count, int ms = 2000) const {
    Bytes bytes;
    pollfd state{port_, POLLIN, 0};
    while (bytes.size() < count && ::poll(&state, 1, ms) == 1) {
      std::array<std::uint8_t, 256> some{};
      const ssize_t got = ::read(port_, some.data(), some.size());
      if (got <= 0) break;
      bytes.insert(bytes.end(), some.begin(), some.begin() + got);
    }
    return bytes;
  }

 private:
  int port_;
};

// A server in a thread of its own, until the test is over.
class Running {
 public:
  explicit Running(ServerSetup setup = {}) : server_(machine, board(), with_files(setup)) {
    thread_ = std::thread([this] { server_.run(stop_); });
  }
  ~Running() { end(); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void end() {
    stop_ = 1;
    wait();
  }
  // Until the console has ended it.
  void wait() {
    if (thread_.joinable()) thread_.join();
  }
  const std::string& name() const { return server_.terminal().name(); }
  // What the server has printed; after end().
  std::string printed() const { return text(out_.get()); }
  std::string errors() const { return text(errors_.get()); }

  tb::Responder machine;

 private:
  using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

  static const controller::Board& board() { return controller::boards().front(); }
  ServerSetup with_files(ServerSetup setup) {
    setup.out = out_.get();
    setup.errors = errors_.get();
    return setup;
  }
  static std::string text(std::FILE* file) {
    std::string all;
    std::rewind(file);
    for (int c = 0; (c = std::fgetc(file)) != EOF;) all += static_cast<char>(c);
    return all;
  }

  volatile std::sig_atomic_t stop_ = 0;
  File out_{std::tmpfile(), std::fclose};
  File errors_{std::tmpfile(), std::fclose};
  Server server_;
  std::thread thread_;
};

ServerSetup fast() {
  ServerSetup setup;
  setup.fast = true;
  return setup;
}

TEST(Server, AnswersInRealTime) {
  Running running;
  const Port port(running.name());
  port.send(kRequest);
  EXPECT_EQ(port.receive(kReply.size()), kReply);
}

// Simulated time is real time, within what a loaded machine gives up and tells.
TEST(Server, TimeIsReal) {
  Running running;
  const auto start = Pace::Clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  running.end();
  const double real = std::chrono::duration<double, std::milli>(Pace::Clock::now() - start).count();
  const double simulated = static_cast<double>(running.machine.now()) / tb::Responder::kClocksPerMs;
  EXPECT_LE(simulated, real + 20);
  EXPECT_GE(simulated, 100);
}

// Within seconds, on however busy a machine.
bool becomes_raw(const std::string& name) {
  for (int i = 0; i < 100; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const Port port(name);
    termios settings{};
    ::tcgetattr(port.descriptor(), &settings);
    if ((settings.c_lflag & (ICANON | ECHO)) == 0) return true;
  }
  return false;
}

// Clients come and go, and leave the terminal in any state.
TEST(Server, ClientsOneAfterTheOther) {
  Running running(fast());
  for (const speed_t speed : {B9600, B19200, B115200, B921600}) {
    {
      const Port port(running.name());
      termios settings{};
      ASSERT_EQ(::tcgetattr(port.descriptor(), &settings), 0);
      ::cfsetspeed(&settings, speed);
      if (speed == B19200) settings.c_lflag |= ICANON | ECHO;
      ASSERT_EQ(::tcsetattr(port.descriptor(), TCSANOW, &settings), 0);
      if (speed != B19200) {
        port.send(kRequest);
        EXPECT_EQ(port.receive(kReply.size()), kReply);
      }
    }
    // The next one finds it raw again, once the server has seen this one go.
    EXPECT_TRUE(becomes_raw(running.name()));
  }
}

TEST(Server, NothingWaitsForTheNextClient) {
  Running running(fast());
  {
    const Port port(running.name());
    port.send(kRequest);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // the answer is there, not read
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const Port port(running.name());
  EXPECT_EQ(port.receive(1, 100), Bytes{});
  port.send(kRequest);
  EXPECT_EQ(port.receive(kReply.size()), kReply);
}

TEST(Server, Link) {
  const std::string link = RUNG_SCRATCH "/device_link";
  fs::remove(link);
  ServerSetup setup = fast();
  setup.link = link;
  {
    Running running(setup);
    EXPECT_EQ(fs::read_symlink(link), running.name());
    const Port port(link);
    port.send(kRequest);
    EXPECT_EQ(port.receive(kReply.size()), kReply);
  }
  EXPECT_FALSE(fs::exists(fs::symlink_status(link)));
  // An old link is replaced, a file is not.
  fs::create_symlink("/nowhere", link);
  { Running running(setup); }
  {
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(link.c_str(), "w"),
                                                         std::fclose);
  }
  try {
    Running running(setup);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("is no symbolic link"), std::string::npos);
  }
  EXPECT_TRUE(fs::is_regular_file(link));
  fs::remove(link);
}

TEST(Server, ConsoleAndWatch) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const std::string text = "in3=1\nadc2=512\nswitch stop\nnonsense\npower off\nshow\nquit\n";
  ASSERT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  ServerSetup setup;
  setup.console = ends[0];
  setup.watch = true;
  Running running(setup);
  running.wait();
  ::close(ends[0]);
  ::close(ends[1]);
  EXPECT_TRUE(running.machine.inputs[3]);
  EXPECT_EQ(running.machine.adc[2], 512);
  EXPECT_FALSE(running.machine.run_switch);
  EXPECT_FALSE(running.machine.power);
  EXPECT_NE(running.printed().find("power off, RUN; outputs that are 1: out3"), std::string::npos)
      << running.printed();
  EXPECT_EQ(running.errors(), "rung device: 'nonsense': no such command; 'help' lists them\n");
}

}  // namespace
}  // namespace rung::device
