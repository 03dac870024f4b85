% SUSPECTLINES  Says of runs how far they are from what the others foretell.
%
% CALL: LINES = suspectLines (STATE, PROBLEM, ROWSOF)
%
%   ROWSOF  1 x k, rows of STATE.data
%   LINES   1 x k cell of texts: 'the run at a = 1 gave x = 6.8; the other runs
%           foretell 1.03'
%
% Of the responses that are fitted, the one that is off most is named; what the
% others foretell is the surrogate without the runs of the set.

function lines = suspectLines (state, problem, rowsOf)
  lines = {};
  data = state.data;
  T = find (problem.calibrate);
  for i = rowsOf(:)'
    isSame = sameSet (data.X, data.X(i, :), problem.limits);
    others = setfield (data, 'Z', {isSame, ':'}, NaN);
    others.Z(horzcat (state.surrogates.leftOut)) = NaN;
    [m, sd] = foretold (state.surrogates(T), others, data.X(i, :), T);
    off = abs (data.Z(i, T) - m) ./ sd;
    [~, k] = max (off);
    lines{end + 1} = sprintf (['the run at %s gave %s = %.4g; the other ' ...
                               'runs predict %.4g'], ...
                              namedValues (problem.names, data.X(i, :), ...
                                           '%.4g'), ...
                              problem.targetNames{T(k)}, data.Z(i, T(k)), ...
                              m(k));
  end
end

function [m, sd] = foretold (surrogates, others, p, T)
  for k = 1:numel (T)
    s = surrogates(k);
    s = fitSurrogate (others.X, others.Z(:, T(k)), s.limits, ...
                      struct ('trend', s.trend, 'covariance', s.covariance));
    [m(k), v] = predictSurrogate (s, p);
    sd(k) = sqrt (v + s.noiseVar);
  end
end

%!test
%! [problem, state, ~, f] = smallCalibration ();
%! state.data.Z(3, 1) += 2;
%! line = suspectLines (state, problem, 3){1};
%! p = state.data.X(3, :);
%! expected = sprintf ('the run at a = %.4g, b = %.4g gave x = %.4g;', p, ...
%!                     state.data.Z(3, 1));
%! assert (line(1:numel (expected)), expected);
%! said = str2double (regexp (line, '[\d.]+$', 'match'){1});
%! assert (said, f (p)(1), 0.05);

% SPDX-License-Identifier: GPL-3.0-only
