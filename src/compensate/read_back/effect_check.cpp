#include "compensate/read_back/effect_check.hpp"

#include <fmt/format.h>

#include "compensate/read_back/block_effects.hpp"
#include "compensate/read_back/difference.hpp"
#include "nc/language/active_comments.hpp"
#include "nc/rewrite/emit.hpp"

namespace plumbline::compensate {
namespace {

// Comments that show nothing and ask for nothing.
bool is_passive(std::string_view comment) {
  for (const nc::ActiveComment& active : nc::kActiveComments) {
    std::size_t at = comment.find_first_not_of("(; \t");
    bool same = at != std::string_view::npos;
    for (const char c : active.word) {
      same = same && at < comment.size() && (comment[at] | 0x20) == c;
      ++at;
    }
    if (same) return false;
  }
  return true;
}

}  // namespace

bool is_bare(const nc::Block& block) {
  return block.words.empty() && block.settings.empty() && block.kind == nc::LineKind::block;
}

void EffectCheck::begin(const IntendedBatch& batch, const IntendedBlock& block) {
  batch_ = &batch;
  block_ = &block;
  next_ = block.first_effect;
  last_ = next_ + block.effects;
}

// What no effect of the original is: the comments that the rewriting adds, and modes that come back.
bool EffectCheck::is_ours(const BlockEffect& effect, const nc::Block& of_output) const {
  if (!effect.is_comment) return block_->steers && effect.is_mode;
  return is_bare(of_output) && is_passive(effect.text) &&
         (unrolled_ || block_->left_out || upper(effect.text).find(upper(nc::kAllStand)) != std::string::npos);
}

bool EffectCheck::take(const BlockEffect& effect, const nc::Block& of_output) {
  if (next_ < last_) {
    const BlockEffect& meant = batch_->effects[next_];
    const bool silenced = unrolled_ && meant.is_comment && effect.text == "(was " + meant.text.substr(1);
    if (silenced || are_alike(meant, effect)) {
      ++next_;
      return !meant.is_comment;
    }
  }
  if (is_ours(effect, of_output)) return false;
  throw Difference{fmt::format("it has {} where {} was meant", text_of(effect),
                               next_ < last_ ? text_of(batch_->effects[next_]) : std::string("nothing"))};
}

void EffectCheck::end() const {
  if (next_ < last_) throw Difference{fmt::format("{} is missing", text_of(batch_->effects[next_]))};
}

}  // namespace plumbline::compensate
