// x86-64-v2: 2 doubles in a register of SSE4.2.
#include "compensate/exact/kernel_carry.hpp"
#include "compensate/exact/kernel_correct.hpp"
#include "compensate/exact/kernel_play.hpp"
#include "compensate/exact/kernel_units.hpp"

namespace plumbline::compensate::exact {
namespace {

struct X86V2 {};

}  // namespace

void correct_on_x86_64_v2(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t poses) {
  correct_blocks<Lanes<X86V2, 2>>(setup, asked, answered, poses);
}

void play_on_x86_64_v2(const Setup& setup, Friction friction, const AskedBlock* asked, PlayedBlock* played,
                       std::size_t poses) {
  play_blocks<Lanes<X86V2, 2>>(setup, friction, asked, played, poses);
}

void carry_on_x86_64_v2(const Setup& setup, Friction friction, const AskedBlock* asked, CarriedBlock* carried,
                        std::size_t poses) {
  carry_blocks<Lanes<X86V2, 2>>(setup, friction, asked, carried, poses);
}

}  // namespace plumbline::compensate::exact
