// plumbline_draw_case: draws a machine, its measurements and what is hidden in them from a seed, and writes them.
#include "truth/case_options.hpp"
#include "truth/run_main.hpp"

namespace {

int draw(int argc, char** argv) {
  CLI::App app("Draws a blind case: a machine whose model misses something that its measurements hold.");
  truth::CaseOptions options;
  std::string out;
  bool quick = false;
  truth::add_case_options(app, options);
  app.add_option(
      "--programs", options.programs,
      "folder with ID.jsonl for each run of the plan: what plumbline trace says of the program to run instead");
  app.add_option("--circle", options.more,
                 "X,Y,Z,A,B,C,ccw,FEED,PAYLOAD in mm, deg, mm/min, kg: a circle that the same machine makes after the "
                 "plan, into the folder more; may be given several times")
      ->expected(1)
      ->type_size(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_flag("--quick", quick, "do not look for effects that look alike");
  app.add_option("-o", out, "folder")->required();
  CLI11_PARSE(app, argc, argv);
  options.look_alikes = !quick;
  truth::check_case_options(options);
  truth::write_case(truth::draw_case(options), out);
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return truth::run_main(draw, argc, argv); }
