// Any processor: what the compiler makes of two doubles side by side, and of one.
#include "compensate/exact/kernel_carry.hpp"
#include "compensate/exact/kernel_correct.hpp"
#include "compensate/exact/kernel_play.hpp"
#include "compensate/exact/kernel_units.hpp"

namespace plumbline::compensate::exact {
namespace {

struct Here {};

}  // namespace

void correct_one_by_one(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t poses) {
  correct_blocks<Lanes<Here, 1>>(setup, asked, answered, poses);
}

void play_one_by_one(const Setup& setup, Friction friction, const AskedBlock* asked, PlayedBlock* played,
                     std::size_t poses) {
  play_blocks<Lanes<Here, 1>>(setup, friction, asked, played, poses);
}

void correct_on_any(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t poses) {
  correct_blocks<Lanes<Here, 2>>(setup, asked, answered, poses);
}

void play_on_any(const Setup& setup, Friction friction, const AskedBlock* asked, PlayedBlock* played,
                 std::size_t poses) {
  play_blocks<Lanes<Here, 2>>(setup, friction, asked, played, poses);
}

void carry_one_by_one(const Setup& setup, Friction friction, const AskedBlock* asked, CarriedBlock* carried,
                      std::size_t poses) {
  carry_blocks<Lanes<Here, 1>>(setup, friction, asked, carried, poses);
}

void carry_on_any(const Setup& setup, Friction friction, const AskedBlock* asked, CarriedBlock* carried,
                  std::size_t poses) {
  carry_blocks<Lanes<Here, 2>>(setup, friction, asked, carried, poses);
}

}  // namespace plumbline::compensate::exact
