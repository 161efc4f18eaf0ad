#include "report/page/paper_sections.hpp"

#include <catch2/catch.hpp>

#include "base/version.hpp"
#include "measure/runs.hpp"
#include "support/page_sections.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("a paper ends with its protocol, who measured and what it rests on, and lines to sign") {
  jobs::Paper paper;
  paper.machine = "pm600-like";
  paper.protocol.serial = "0042";
  paper.protocol.operator_ = "<b>E. Maier</b>";
  paper.files = {{"data", "dataset.toml", 0xABC}};
  paper.runs = {circle_run({0, 100, -1008}, {0, 0, 0})};
  report::Page page{"Title", "Lead."};
  report::add_paper(page, paper);
  const std::string protocol = page.sections.back().dump();
  for (const char* const words : {"0042", "<b>E. Maier</b>", "0000000000000abc", "signature"}) {
    INFO(words);
    CHECK(protocol.find(words) != std::string::npos);
  }
  CHECK(protocol.find(std::string(version())) != std::string::npos);
  // torques of the run, as curves and as least and most
  CHECK(page.sections.size() == 3);
  CHECK(page.sections[1].dump().find("0.00 to 0.00") != std::string::npos);
  // the whole page holds them, as text
  CHECK(report::page_text(page).find("<b>E. Maier") == std::string::npos);
}
