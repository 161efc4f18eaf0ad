// Blocks that write nothing: of however many of them the output is read back without waiting for a line behind them.
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

/// Ends the test program where what is tested waits for ever.
class TimeLimit {
 public:
  explicit TimeLimit(std::chrono::seconds limit)
      : thread_([this, limit] {
          std::unique_lock lock(guard_);
          if (changed_.wait_for(lock, limit, [this] { return done_; })) return;
          std::fputs("the output was not read to its end in time\n", stderr);
          std::_Exit(EXIT_FAILURE);
        }) {}
  ~TimeLimit() {
    {
      const std::scoped_lock lock(guard_);
      done_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;

 private:
  std::mutex guard_;
  std::condition_variable changed_;
  bool done_ = false;
  std::thread thread_;
};

void check_ends(const std::string& control, const std::string& text) {
  INFO(control << "\n" << text);
  const TimeLimit limit(std::chrono::seconds(120));
  Job job = job_of_control(control);
  job.program.max_blocks = 1'000'000;
  const Result result = run(text, job);
  REQUIRE(result.summary.read_back);
  CHECK(result.summary.unrolled);
  CHECK(result.summary.read_back->blocks == result.summary.blocks);
}

}  // namespace

TEST_CASE("many blocks that write nothing do not stop the read-back of an OSP") {
  const std::string begin = "O1\nG15 H1\nG90 G94 G0 X0 Y0 Z50. A0 B0 C0\n";
  for (const std::string rest :
       {"CALL OA Q3000\nM2\nOA\nRTS\n", "VC1=0\nNL IF [VC1 GE 2500] NEND\nVC1=VC1+1\nGOTO NL\nNEND G1 X5. F100\nM2\n",
        "G1 X5. F100\nVC1=0\nNL VC1=VC1+1\nIF [VC1 LT 50000] NL\nX6.\nM2\n",
        "VC1=0\nNL VC1=VC1+1\nIF [VC1 LT 9000] NL\n(COUNTED)\nCALL OA\nM2\nOA\nG1 X5. F100\n$ Y6.\nRTS\n",
        "G1 X5. F100\nVC1=0\nNL VC1=VC1+1\nIF [VC1 LT 9000] NL\nM2"}) {
    check_ends("okuma", begin + rest);
  }
}

TEST_CASE("many blocks that write nothing do not stop the read-back of other controls") {
  const std::string begin = "G90 G94 G17 G54\nG0 X0. Y0. Z50. A0. B0. C0.\n";
  check_ends("linuxcnc", begin + "#1=0\no1 while [#1 lt 9000]\n#1=[#1+1]\no1 endwhile\nG1 X5 F100\nM2\n");
  check_ends("linuxcnc", begin + "o1 sub\no1 endsub\no2 repeat [5000]\no1 call\no2 endrepeat\nM2\n");
  check_ends("fanuc", "O1\nG21\n" + begin + "#1=0\nWHILE[#1LT9000]DO1\n#1=#1+1\nEND1\nG1 X5. F100\nM30\n");
  check_ends("fanuc",
             "O1\nG21\n" + begin + "M98 P50002\nG1 X5. F100.\nM98 P30003\nM30\nO2\nM99\nO3\nM98 P90002\nM99\n");
  check_ends("siemens", begin + "R1=0\nLOOP:\nR1=R1+1\nIF R1<9000 GOTOB LOOP\nG1 X5 F100\nR1=0\nM30\n");
}

TEST_CASE("a first block that writes nothing is not held against the block behind the comments that mark the output") {
  for (const std::string first : {"M70\n", "M71\n", "M73\n", "(MSG, a)\nM70\n"}) {
    for (const std::string next : {"G20 G91\n", "G19\nG17\n", "M8\n", "G61\n", "(MSG, b)\n", "G55\nG54\n"}) {
      check_ends("linuxcnc",
                 first + next + "G90 G21\nG0 X0 Y0 Z50 A0 B0 C0\no1 repeat [2]\nG1 X1 F100\no1 endrepeat\nM2\n");
    }
  }
}
