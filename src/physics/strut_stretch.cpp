#include "physics/strut_stretch.hpp"

namespace plumbline::physics {

template StrutStretch<double> strut_stretch_at(const ForceModel&, const double*, const Environment&,
                                               const Motion<double>&, const StrutRates<double>&, const Pose<double>&,
                                               const machine::StrutGeometry<double>&);
template StrutStretch<double> strut_stretch(const ForceModel&, const double*, const Environment&,
                                            const Motion<double>&);

}  // namespace plumbline::physics
