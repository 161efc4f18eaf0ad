// What a model needs and nobody stated of the machine: assumed, by rules that are said.
#pragma once

#include "jobs/new_model/model_draft.hpp"

namespace plumbline::jobs {

/// Completes a draft that has the joints of base and platform and the place of home, or a travel in all three axes,
/// whose middle is home then.
///   - A, B, C turn in the order ZYX; gravity is the standard one; the gauge point is the origin of P.
///   - Struts become a quarter shorter and longer than at home.
///   - The platform tilts as far as the struts let it at home, in whole degrees, at most 30.
///   - Travel is the largest cube about home all of which is in reach, not tilted and on home's side of singularities.
///   - Masses, lengths of parts, compliances, friction and lead are those of the PM-600 (models/pm600-like.toml), built
///     larger or smaller by s, the mean strut length at home over the PM-600's: lengths as s, masses as s^3,
///     K1 as 1/s^2, K2 as 1/s, friction as s^2.
///   - The platform's centre of mass is the middle of its joints.
///   - Joints and lengths of struts are known to 1 mm, as calibrate takes those that nobody measured (1 sigma).
///   - What is assumed of masses, compliances, friction and the centre of mass is known to half of itself (1 sigma).
/// Refuses with draft-missing where home is not known, and with draft-reach where no travel can be assumed.
void assume_the_rest(ModelDraft& draft);

}  // namespace plumbline::jobs
