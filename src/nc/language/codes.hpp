// Every code that a diagnostic of this module can carry. Each has a program in tests/nc/bad that provokes it.
#pragma once

#include <array>
#include <string_view>

namespace plumbline::nc::codes {

// Reading
inline constexpr std::string_view kLineTooLong = "nc-line-too-long";
inline constexpr std::string_view kNulByte = "nc-nul-byte";
inline constexpr std::string_view kNotAscii = "nc-not-ascii";
inline constexpr std::string_view kBadCharacter = "nc-bad-character";
inline constexpr std::string_view kCommentOpen = "nc-comment-open";
inline constexpr std::string_view kCommentNested = "nc-comment-nested";
inline constexpr std::string_view kPercentText = "nc-percent-text";
inline constexpr std::string_view kLineNumber = "nc-line-number";
inline constexpr std::string_view kValueMissing = "nc-value-missing";
inline constexpr std::string_view kBadNumber = "nc-bad-number";
inline constexpr std::string_view kBracketOpen = "nc-bracket-open";
inline constexpr std::string_view kOperator = "nc-operator";
inline constexpr std::string_view kFunction = "nc-function";
inline constexpr std::string_view kName = "nc-name";
inline constexpr std::string_view kAssignment = "nc-assignment";
inline constexpr std::string_view kWordTwice = "nc-word-twice";
inline constexpr std::string_view kFlowControl = "nc-flow-control";

// Values
inline constexpr std::string_view kParameterNumber = "nc-parameter-number";
inline constexpr std::string_view kParameterUnset = "nc-parameter-unset";
inline constexpr std::string_view kParameterReadOnly = "nc-parameter-read-only";
inline constexpr std::string_view kArithmetic = "nc-arithmetic";
inline constexpr std::string_view kValueUnknown = "nc-value-unknown";
inline constexpr std::string_view kPositionRead = "nc-position-read";
inline constexpr std::string_view kNotWhole = "nc-not-whole";
inline constexpr std::string_view kNegative = "nc-negative";
inline constexpr std::string_view kOutOfRange = "nc-out-of-range";

// Codes and their words
inline constexpr std::string_view kToolVector = "nc-tool-vector";
inline constexpr std::string_view kTiltedPlane = "nc-tilted-plane";
inline constexpr std::string_view kUnknownCode = "nc-unknown-code";
inline constexpr std::string_view kNotInterpreted = "nc-not-interpreted";
inline constexpr std::string_view kUserCode = "nc-user-code";
inline constexpr std::string_view kSameGroup = "nc-same-group";
inline constexpr std::string_view kWordUnused = "nc-word-unused";
inline constexpr std::string_view kWordMissing = "nc-word-missing";
inline constexpr std::string_view kAxesUnused = "nc-axes-unused";
inline constexpr std::string_view kAxesTwice = "nc-axes-twice";
inline constexpr std::string_view kAxesMissing = "nc-axes-missing";
inline constexpr std::string_view kBlockDelete = "nc-block-delete";

// Motion
inline constexpr std::string_view kFeedMissing = "nc-feed-missing";
inline constexpr std::string_view kArcWords = "nc-arc-words";
inline constexpr std::string_view kArcRadius = "nc-arc-radius";
inline constexpr std::string_view kArcEnds = "nc-arc-ends";
inline constexpr std::string_view kArcTurns = "nc-arc-turns";
inline constexpr std::string_view kMachineMove = "nc-machine-move";
inline constexpr std::string_view kSpindleStands = "nc-spindle-stands";

// What the program needs and was never given
inline constexpr std::string_view kWorkOffsetUnknown = "nc-work-offset-unknown";
inline constexpr std::string_view kPositionUnknown = "nc-position-unknown";
inline constexpr std::string_view kToolUnknown = "nc-tool-unknown";
inline constexpr std::string_view kFlowLabel = "nc-flow-label";
inline constexpr std::string_view kFlowOpen = "nc-flow-open";
inline constexpr std::string_view kModesNotSaved = "nc-modes-not-saved";
inline constexpr std::string_view kCallDepth = "nc-call-depth";
inline constexpr std::string_view kTooManyBlocks = "nc-too-many-blocks";
inline constexpr std::string_view kGuard = "nc-guard";
inline constexpr std::string_view kUnknownDialect = "nc-unknown-dialect";
inline constexpr std::string_view kDialectAmbiguous = "nc-dialect-ambiguous";

inline constexpr std::array kAll{kLineTooLong,
                                 kNulByte,
                                 kNotAscii,
                                 kBadCharacter,
                                 kCommentOpen,
                                 kCommentNested,
                                 kPercentText,
                                 kLineNumber,
                                 kValueMissing,
                                 kBadNumber,
                                 kBracketOpen,
                                 kOperator,
                                 kFunction,
                                 kName,
                                 kAssignment,
                                 kWordTwice,
                                 kFlowControl,
                                 kParameterNumber,
                                 kParameterUnset,
                                 kParameterReadOnly,
                                 kArithmetic,
                                 kValueUnknown,
                                 kPositionRead,
                                 kNotWhole,
                                 kNegative,
                                 kOutOfRange,
                                 kUnknownCode,
                                 kNotInterpreted,
                                 kTiltedPlane,
                                 kUserCode,
                                 kSameGroup,
                                 kWordUnused,
                                 kWordMissing,
                                 kAxesUnused,
                                 kAxesTwice,
                                 kAxesMissing,
                                 kBlockDelete,
                                 kFeedMissing,
                                 kArcWords,
                                 kArcRadius,
                                 kArcEnds,
                                 kArcTurns,
                                 kMachineMove,
                                 kWorkOffsetUnknown,
                                 kPositionUnknown,
                                 kToolUnknown,
                                 kUnknownDialect,
                                 kFlowLabel,
                                 kFlowOpen,
                                 kModesNotSaved,
                                 kCallDepth,
                                 kTooManyBlocks,
                                 kGuard,
                                 kToolVector,
                                 kDialectAmbiguous,
                                 kSpindleStands};

}  // namespace plumbline::nc::codes
