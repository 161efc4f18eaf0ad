// What makes a page a paper to sign: whose machine, measured by whom with what, the files it rests on, the figures of
// the standard, the torques along the turn.
#pragma once

#include "jobs/measured/paper.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// Adds the protocol with lines to sign at the end of a page; before it, where the page does not have them yet, the
/// figures of ISO 230-4 and the torques.
void add_paper(Page& page, const jobs::Paper& paper, bool with_figures = true);

/// The figures of every run, and of every pair; null: there are none.
Json figures_table(const jobs::CircularityTable& table);
Json pairs_table(const jobs::CircularityTable& table);

}  // namespace plumbline::report
