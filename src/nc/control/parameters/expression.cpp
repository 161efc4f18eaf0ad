#include "nc/control/parameters/expression.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/check.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {
namespace {

constexpr double kTurn = 360;

bool is_binary(Operation operation) {
  return (operation >= Operation::power && operation <= Operation::remainder) || operation == Operation::arc_tangent ||
         operation == Operation::arc_tangent_turn || operation == Operation::smaller || operation == Operation::larger;
}

double truth(bool value) { return value ? 1 : 0; }

// Half a turn in radians is long double, as in LinuxCNC's interpreter, whose products are rounded where these are: the
// sine of 30 is 0.5 to the last bit, FIX of ten times it 5, and ASIN of it 30 [LinuxCNC, measured].
constexpr long double kHalfTurnRadians = std::numbers::pi_v<long double>;
constexpr double kHalfTurn = 180;

long double to_radians(double degrees) { return degrees * kHalfTurnRadians / kHalfTurn; }

double to_degrees(double radians) {
  const double product = radians * kHalfTurn;
  return static_cast<double>(product / kHalfTurnRadians);
}

// Every number that a parameter may have is one's [LinuxCNC, measured].
Value number_exists(const Block& block, Span span, Value value, ParameterLimits limits) {
  if (!value.known) return {0, false};
  const int number = whole_number(block, span, value.number, "the number of a parameter");
  return {truth(number >= limits.first && number <= limits.last), true};
}

double modulo(double a, double b) {
  const double rest = std::fmod(a, b);
  return rest < 0 ? rest + std::abs(b) : rest;
}

double of_two(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::arc_tangent:
      return to_degrees(std::atan2(a, b));
    case Operation::arc_tangent_turn: {
      const double angle = to_degrees(std::atan2(a, b));
      return angle < 0 ? angle + kTurn : angle;
    }
    case Operation::smaller:
      return std::min(a, b);
    case Operation::larger:
      return std::max(a, b);
    case Operation::whole_quotient:
      return std::trunc(a / b);
    case Operation::remainder:
    case Operation::whole_remainder:
      return std::fmod(a, b);
    case Operation::power:
      return std::pow(a, b);
    case Operation::times:
      return a * b;
    case Operation::divide:
      return a / b;
    case Operation::modulo:
      return modulo(a, b);
    case Operation::plus:
      return a + b;
    case Operation::minus:
      return a - b;
    case Operation::logical_and:
      return truth(a != 0 && b != 0);
    case Operation::logical_or:
      return truth(a != 0 || b != 0);
    case Operation::exclusive_or:
      return truth((a != 0) != (b != 0));
    default:
      break;
  }
  PLUMBLINE_CHECK(false);
  return 0;
}

// A whole number as the control holds it for AND, OR and XOR.
std::int64_t bits_of(const Block& block, Span span, const Value& value) {
  const int number = value.known ? whole_number(block, span, value.number, "what AND, OR and XOR work on") : 0;
  if (number >= 0) return number;
  refuse_at(block, span, codes::kNegative, "AND, OR and XOR of a negative number are not interpreted",
            "which bits it has depends on the control; keep to 0 and more");
}

double of_bits(const Block& block, const Instruction& step, const Value& a, const Value& b) {
  const std::int64_t left = bits_of(block, step.span, a);
  const std::int64_t right = bits_of(block, step.span, b);
  const bool both = step.operation == Operation::bit_and;
  return static_cast<double>(both ? left & right : step.operation == Operation::bit_or ? left | right : left ^ right);
}

bool is_of_bits(Operation operation) {
  return operation >= Operation::bit_and && operation <= Operation::bit_exclusive_or;
}

double of_one(Operation operation, double a) {
  switch (operation) {
    case Operation::negate:
      return -a;
    case Operation::absolute:
      return std::abs(a);
    case Operation::truncate:
      return std::trunc(a);
    case Operation::round_away:
      return a < 0 ? std::floor(a) : std::ceil(a);
    case Operation::arc_tangent_of_one:
      return to_degrees(std::atan(a));
    case Operation::square:
      return a * a;
    case Operation::logical_not:
      return truth(a == 0);
    case Operation::arc_cosine:
      return to_degrees(std::acos(a));
    case Operation::arc_sine:
    case Operation::macro_arc_sine:
      return to_degrees(std::asin(a));
    case Operation::cosine:
      return static_cast<double>(std::cos(to_radians(a)));
    case Operation::exponential:
      return std::exp(a);
    case Operation::round_down:
      return std::floor(a);
    case Operation::round_up:
      return std::ceil(a);
    case Operation::logarithm:
      return std::log(a);
    case Operation::sine:
      return static_cast<double>(std::sin(to_radians(a)));
    case Operation::square_root:
      return std::sqrt(a);
    case Operation::tangent:
      return static_cast<double>(std::tan(to_radians(a)));
    default:
      break;
  }
  PLUMBLINE_CHECK(false);
  return 0;
}

// A parameter of the control (6004#0, NAT) says whether angles go on to 360 or come from -90.
void check_arc_sine(const Block& block, const Instruction& step, const Value& value) {
  if (step.operation != Operation::macro_arc_sine || !value.known || value.number >= 0) return;
  refuse_at(block, step.span, codes::kNotInterpreted,
            fmt::format("ASIN of {:.6g}: whether that is an angle below 0 or one below 360 depends on a parameter of "
                        "the control (6004, NAT)",
                        value.number),
            "write the angle itself, or -ASIN of the number without its sign");
}

// Some controls round both numbers first, others do not; of numbers below zero the manuals give no example.
void check_remainder(const Block& block, const Instruction& step, const Value& a, const Value& b) {
  if (step.operation != Operation::whole_remainder && step.operation != Operation::whole_quotient) return;
  for (const Value& value : {a, b}) {
    if (!value.known) continue;
    if (value.number != std::trunc(value.number)) {
      refuse_at(block, step.span, codes::kNotWhole,
                fmt::format("what {} divides, or divides by, is no whole number", block.at(step.span)),
                "round it before: what becomes of a fraction was found in no source");
    }
    if (value.number >= 0) continue;
    refuse_at(block, step.span, codes::kNotInterpreted,
              fmt::format("{} of a number below zero was found in no source", block.at(step.span)),
              "make the number positive before, as with ABS, and give the result its sign");
  }
}

void check_angle(const Block& block, const Instruction& step, const Value& a, const Value& b) {
  if (step.operation != Operation::arc_tangent || !a.known || !b.known || a.number != 0 || b.number != 0) return;
  refuse_at(block, step.span, codes::kArithmetic, "the angle of (0,0) was found in no source",
            "look for the difference that is zero, or ask for it before");
}

}  // namespace

// AND and OR give the same for 0 and 1, whether they join truths or bits.
void Evaluator::check_truths(const Block& block, const Instruction& step) const {
  for (std::size_t i = stack_.size() - 2; i < stack_.size(); ++i) {
    const Value& value = stack_[i];
    if (!value.known || value.number == 0 || value.number == 1) continue;
    refuse_at(block, step.span, codes::kNotInterpreted,
              fmt::format("{} joins {:.6g}: whether the control joins truths or bits was found in no source",
                          block.at(step.span), value.number),
              "join conditions, which are 0 or 1, as in [VC1 EQ 3] AND [VC2 LT 4]");
  }
}

// BOUND(40,10,R1), before the smaller of the last two is taken.
void Evaluator::check_bounds(const Block& block, const Instruction& step) const {
  const Value& least = *(stack_.end() - 3);
  const Value& most = *(stack_.end() - 2);
  if (!least.known || !most.known || least.number <= most.number) return;
  refuse_at(block, step.span, codes::kNotInterpreted,
            fmt::format("{} has a minimum over its maximum, and what it gives then was found in no source",
                        block.at(step.span)),
            "write the smaller of the two first, as in BOUND(10,40,R1)");
}

// Numbers as they were written are compared as they are.
bool Evaluator::are_doubtful(const Value& a, const Value& b) const {
  if (doubtful_within_ <= 0 || !a.known || !b.known || (!a.rounded && !b.rounded)) return false;
  return std::abs(a.number - b.number) <= doubtful_within_ * std::max({1.0, std::abs(a.number), std::abs(b.number)});
}

// 0.1+0.2, 1/3 and SIN[30] are; 1+2, 0.5*3 and what FIX, FUP and ROUND make whole are not.
bool Evaluator::is_rounded(const Instruction& step, const Value& result, const Value& a, const Value& b) const {
  if (doubtful_within_ <= 0 || (step.operation >= Operation::equal && step.operation <= Operation::bit_exclusive_or))
    return false;
  const auto keeps_digits = [](double number) {
    constexpr double kParts = 1024;
    return number * kParts == std::trunc(number * kParts);
  };
  const bool cuts = step.operation == Operation::truncate || step.operation == Operation::round_away ||
                    step.operation == Operation::round;
  if (cuts) return false;
  const bool works_out =
      is_binary(step.operation) || (step.operation != Operation::negate && step.operation != Operation::absolute);
  if (!works_out) return b.rounded;
  const bool of_whole = is_binary(step.operation) && step.operation != Operation::arc_tangent &&
                        step.operation != Operation::arc_tangent_turn && step.operation != Operation::power;
  return a.rounded || b.rounded || !of_whole || !keeps_digits(a.number) || !keeps_digits(b.number) ||
         !keeps_digits(result.number);
}

// #1=#1+0.1 until it is 1: the sum depends on the digits that the control keeps.
void Evaluator::check_digits(const Block& block, const Instruction& step, const Value& a, const Value& b) const {
  if (!is_relation(step.operation) || !are_doubtful(a, b)) return;
  refuse_at(block, step.span, codes::kNotInterpreted,
            fmt::format("{:.6g} and what it is compared with are the same but for the last digits: what comes out "
                        "depends on how many of them the control keeps",
                        a.number),
            "compare with a number that lies between two values, as 0.95 where steps of 0.1 go to 1, or count by whole "
            "numbers");
}

void Evaluator::check_whole_digits(const Block& block, const Instruction& step, const Value& value) const {
  const bool cuts = step.operation == Operation::truncate || step.operation == Operation::round_away;
  const double half = step.operation == Operation::round ? 0.5 : 0;
  if ((!cuts && half == 0) || !are_doubtful(value, {std::round(value.number - half) + half, true})) return;
  refuse_at(block, step.span, codes::kNotInterpreted,
            fmt::format("{:.6g} lies so near where {} goes on to the next number that what comes out depends on how "
                        "many digits the control keeps",
                        value.number, block.at(step.span)),
            "add or take off a little, 0.001, before it");
}

// What such a variable counts as was found in no source.
void Evaluator::check_vacant(const Block& block, const Instruction& step, const Value& a, const Value& b) const {
  if (vacant_is_zero_ || (!a.vacant && !b.vacant)) return;
  const Instruction* const before = &step - 1;
  const bool compares = step.operation == Operation::equal || step.operation == Operation::not_equal;
  if (compares && (before[0].operation == Operation::vacant || before[-1].operation == Operation::vacant)) return;
  const Instruction* const of_b = before;  // of a: where b is one instruction long
  const bool is_short = before->operation == Operation::number || before->operation == Operation::name;
  const Instruction* const operand = b.vacant ? of_b : is_short ? of_b - 1 : nullptr;
  const bool is_variable =
      operand != nullptr && (operand->operation == Operation::name || operand->operation == Operation::parameter);
  refuse_at(block, is_variable ? operand->span : step.span, codes::kParameterUnset,
            is_variable ? fmt::format("{} was never set", block.at(operand->span))
                        : fmt::format("a value that {} works on was never set", block.at(step.span)),
            "set the variable before, or ask with EQ EMPTY");
}

// [#3] EQ #0 holds if the brackets leave #3 vacant, and [#3] EQ 0 if they make it 0.
void Evaluator::check_bracketed(const Block& block, const Instruction& step, const Value& a, const Value& b) {
  const bool compares = step.operation == Operation::equal || step.operation == Operation::not_equal;
  if (!compares || a.bracketed == b.bracketed || (a.known && b.known && a.number != b.number)) return;
  refuse_at(block, step.span, codes::kParameterUnset,
            "a variable that was never given a value is compared in brackets: whether it counts as 0 there was found "
            "in no source",
            "write the variable without brackets");
}

Value Evaluator::joined(const Block& block, const Instruction& step, const Value& a, const Value& b) const {
  Value result{0, a.known && b.known};
  check_remainder(block, step, a, b);
  if (unsourced_refused_) check_angle(block, step, a, b);
  check_vacant(block, step, a, b);
  check_digits(block, step, a, b);
  check_bracketed(block, step, a, b);
  // To be vacant is not to be zero, for EQ and NE alone [B-63174EN, 13.1].
  const bool differ = a.vacant != b.vacant;
  if (differ && step.operation == Operation::equal) return result;
  if (differ && step.operation == Operation::not_equal) return {1, result.known};
  if (is_of_bits(step.operation)) {
    result.number = of_bits(block, step, a, b);
  } else if (is_relation(step.operation)) {
    if (result.known) result.number = truth(compares(block, step, a.number, b.number, equality_));
  } else {
    result.number = of_two(step.operation, a.number, b.number);
  }
  result.rounded = is_rounded(step, result, a, b);
  return result;
}

Value Evaluator::of_one_operand(const Block& block, const Instruction& step, const Value& b) const {
  if (step.operation != Operation::negate) check_vacant(block, step, b, b);
  check_arc_sine(block, step, b);
  check_whole_digits(block, step, b);
  Value result{of_one(step.operation, b.number), b.known};
  result.rounded = is_rounded(step, result, b, b);
  const bool whole_value = (&step)[1].operation == Operation::end;
  result.vacant = b.vacant && step.operation == Operation::negate && whole_value;
  return result;
}

Value Evaluator::run(const Block& block, std::uint32_t code, ParameterReader& parameters, const Rounding& rounding) {
  stack_.clear();
  for (const Instruction* step = &block.code[code]; step->operation != Operation::end; ++step) {
    switch (step->operation) {
      case Operation::number:
        stack_.push_back({step->number, true});
        continue;
      case Operation::vacant:
        stack_.push_back({0, true, true});
        continue;
      case Operation::name:
        stack_.push_back(parameters.read(block, block.at(block.names[step->name]), step->span));
        continue;
      case Operation::exists:
        stack_.push_back(parameters.exists(block, block.at(block.names[step->name]), step->span));
        continue;
      case Operation::exists_number:
        stack_.back() = number_exists(block, step->span, stack_.back(), parameters.limits());
        continue;
      case Operation::parameter:
        stack_.back() =
            parameters.read(block, parameter_number(block, step->span, stack_.back(), parameters.limits()), step->span);
        continue;
      case Operation::bracketed:
        stack_.back().bracketed = stack_.back().vacant;
        continue;
      case Operation::check_truths:
        check_truths(block, *step);
        continue;
      case Operation::smaller:
        if (step->number != 0) check_bounds(block, *step);
        break;
      default:
        break;
    }
    const Value b = stack_.back();
    Value result{0, b.known};
    if (is_binary(step->operation)) {
      stack_.pop_back();
      result = joined(block, *step, stack_.back(), b);
    } else if (step->operation == Operation::round) {
      check_vacant(block, *step, b, b);
      if (rounding.quantum == 1) check_whole_digits(block, *step, b);
      if (unsourced_refused_) check_half(block, step->span, b);
      result.number = rounded(block, step->span, b.number, rounding);
    } else {
      result = of_one_operand(block, *step, b);
    }
    if (result.known && !std::isfinite(result.number)) {
      refuse_at(block, step->span, codes::kArithmetic, fmt::format("{} has no value here", block.at(step->span)),
                "look for a division by zero, a root or logarithm of a negative number, an angle's sine over 1");
    }
    stack_.back() = result;
  }
  PLUMBLINE_CHECK(stack_.size() == 1);
  return stack_.back();
}

}  // namespace plumbline::nc
