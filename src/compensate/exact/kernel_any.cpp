// Any processor: what the compiler makes of two doubles side by side, and of one.
#include "compensate/exact/kernel.hpp"
#include "compensate/exact/kernel_units.hpp"

namespace plumbline::compensate::exact {
namespace {

struct Here {};

}  // namespace

void correct_one_by_one(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t poses) {
  correct_blocks<Lanes<Here, 1>>(setup, asked, answered, poses);
}

void correct_on_any(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t poses) {
  correct_blocks<Lanes<Here, 2>>(setup, asked, answered, poses);
}

}  // namespace plumbline::compensate::exact
