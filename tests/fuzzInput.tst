% Random damage to the input: every fault is one of DEcalioc, none is a crash.

%!test
%! [findings, counts] = fuzzInput (300, 1, 0.05);
%! assert (isempty (findings), strjoin ([findings, {''}], "\n"));
%! assert (counts(1) > 100);

%!testif ; strcmp (getenv ('DECALIOC_SOAK'), '1')
%! [findings, counts] = fuzzInput (10000, 2, 0.3);
%! assert (isempty (findings), strjoin ([findings, {''}], "\n"));
%! assert (sum (counts(1:2)), 10000);

% SPDX-License-Identifier: GPL-3.0-only
