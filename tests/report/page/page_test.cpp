#include "report/page/page.hpp"

#include <limits>
#include <string>

#include <catch2/catch.hpp>

#include "report/page/sections.hpp"

namespace plumbline {
namespace {

using report::Json;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::string data_of(const std::string& page) {
  const std::string open = R"(<script type="application/json" id="data">)";
  const std::size_t begin = page.find(open) + open.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

TEST_CASE("a page holds its data once, and a policy that forbids the net") {
  const std::string page = report::page_text({.title = "Part 7", .lead = "All is well."});
  const Json data = Json::parse(data_of(page));
  CHECK(data["title"] == "Part 7");
  CHECK(data["lead"] == "All is well.");
  CHECK(count(page, "</html>") == 1);
  const std::size_t begin = page.find("Content-Security-Policy");
  const std::string policy = page.substr(begin, page.find("\">", begin) - begin);
  CHECK(count(policy, "default-src 'none'") == 1);
  CHECK(count(policy, "'sha256-") == 6);  // three.js, its controls and wide lines, D3, the modules, the style
  for (const char* const open : {"unsafe", "http", "*", "'self'"}) CHECK(count(policy, open) == 0);
}

TEST_CASE("libraries of a scene are in the pages that have one") {
  const std::string flat = report::page_text({.title = "t"});
  const std::string scene = report::page_text({.title = "t", .has_scene = true});
  CHECK(scene.size() > flat.size() + 500000);
  CHECK(scene.find("OrbitControls = function") != std::string::npos);
  CHECK(flat.find("OrbitControls = function") == std::string::npos);
}

TEST_CASE("nothing in the data ends the block that holds it") {
  const std::string hostile = "</script><script>alert(1)</script><!-- \xff & \" '";
  const std::size_t scripts = count(report::page_text({.title = "t"}), "<script");
  const std::string page =
      report::page_text({.title = hostile,
                         .lead = hostile,
                         .sections = {report::text_section(hostile, {hostile}),
                                      report::table_section(hostile, {{hostile, hostile}}, {Json::array({hostile})})}});
  CHECK(count(page, "<script") == scripts);
  CHECK(data_of(page).find('<') == std::string::npos);
  const Json data = Json::parse(data_of(page));
  CHECK(data["title"] == "</script><script>alert(1)</script><!-- \xef\xbf\xbd & \" '");
}

TEST_CASE("many numbers are packed as multiples of a quantum") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> values{0, 1, -1, 0.25, none, 1e12};
  const Json json = report::packed(values, 0.25);
  CHECK(json["quantum"] == 0.25);
  // 0, 4, -4, 1, and twice the number that stands for none.
  CHECK(json["data"] == "AAAAAAQAAAD8////AQAAAAAAAIAAAACA");
  CHECK(report::packed({}, 1)["data"] == "");
  CHECK(report::packed(std::vector<double>{1}, 1)["data"] == "AQAAAA==");
}

}  // namespace
}  // namespace plumbline
