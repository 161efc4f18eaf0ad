#include "batch/in_order.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;
using State = jobs::BatchItem::State;

TEST_CASE("items are told of in their order, refused ones last, and subprograms are told apart") {
  std::string told;
  std::vector<std::uint64_t> progress;
  const batch::Observer observer{
      [&](const jobs::BatchItem& item) { told += item.program + (item.state == State::subprogram ? "(sub) " : " "); },
      [&](std::uint64_t done, std::uint64_t) { progress.push_back(done); }};
  batch::InOrder order(observer, 4);
  order.take(2, {"/c", "", State::done, "", {}});
  order.take(0, {"/a", "", State::failed, "", {}});
  CHECK(told.empty());
  order.take(1, {"/b", "", State::unchanged, "", {}});
  CHECK(told == "/b /c ");
  order.take(3, {"/d", "", State::failed, "", {}});
  order.finish({"/d"});
  CHECK(told == "/b /c /a /d(sub) ");
  CHECK(progress == std::vector<std::uint64_t>{1, 2, 3, 4});
  CHECK(order.summary().done == 1);
  CHECK(order.summary().unchanged == 1);
  CHECK(order.summary().failed == 1);
  CHECK(order.summary().subprograms == 1);
}
