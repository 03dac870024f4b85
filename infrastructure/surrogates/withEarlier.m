% WITHEARLIER  Adds to a problem what is known before the first run.
%
% CALL: PROBLEM = withEarlier (PROBLEM, CASE)
%
%   PROBLEM  see newProblem; gets prior (of Input.similar, see similarPriors), shape
%            and others (of form.csv, see knownShapes)
%   CASE     see newCase
%
% Errors: those of knownShapes, loadSurrogate

function problem = withEarlier (problem, Case)
  problem.prior = similarPriors (Case);
  [problem.shape, problem.others] = knownShapes (Case);
end

%!test
%! Case = struct ('options', struct (), 'targets', struct ('value', {1, 2}));
%! known = withEarlier (struct ('tol', 1), Case);
%! assert (isempty (known.others));
%! known = rmfield (known, 'others');
%! assert (known, struct ('tol', 1, 'prior', {cell(1, 0)}, 'shape', {cell(1, 2)}));

% SPDX-License-Identifier: GPL-3.0-only
