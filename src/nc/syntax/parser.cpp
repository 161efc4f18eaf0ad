#include "nc/syntax/parser.hpp"

#include "nc/syntax/rs274/rs274_grammar.hpp"

namespace plumbline::nc {

void Parser::parse(Block& block) {
  reading_.out.begin(block);
  reading_.cursor.begin(block, byte_order_mark_size(block));
  if (reading_.syntax->names) {
    named_.read(reading_);
  } else {
    read_rs274_block(reading_);
  }
}

}  // namespace plumbline::nc
