// Programs for LinuxCNC.
#pragma once

#include <map>

#include "drawn/writer.hpp"

namespace plumbline::drawn {

class LinuxCnc final : public Writer {
 public:
  LinuxCnc(std::uint64_t seed, const Scene& scene);

 private:
  void head() override;
  void piece() override;
  void tail() override;
  std::string switch_word() override;
  std::string comment() override;
  Spelled parameter();
  std::string expression(Spelled& number) override;
  bool has_turns() const override { return true; }

  void change_mode();
  void change_offset();
  void select_system(int system);
  void set_table(int system);
  void set_system_here();
  void set_position();
  void change_tool();
  void tool_length();
  void dwell();
  void cycle();
  void flow();
  void spline();
  void nurbs();
  void polar();
  void go_home();
  void length_by_words();
  void stop();
  std::string there_and_back() override;
  std::string label();

  struct System {
    AxisWords origin;
    double turned_deg = 0;
  };
  std::array<System, 9> systems_;
  int system_ = 1;
  AxisWords stored_;
  int tool_ = 0;
  double length_ = 0;  // in force
  bool offsets_anew_ = false;
  int labels_ = 0;
  std::vector<std::string> programs_;  // that M98 calls
  std::vector<std::pair<std::string, double>> parameters_;
};

}  // namespace plumbline::drawn
