% WHYMORE  Why more runs are made: the result that is least sure to be met.
%
% CALL: TEXT = whyMore (STATE, PROBLEM, N)
%
%   N     runs that follow
%   TEXT  'infill: force scatters by 1.6 a run, the tolerance is 1.4: 6 more runs'

function text = whyMore (state, problem, n)
  p = state.found.params;
  [m, v] = predictSurrogate (state.surrogates, p);
  [~, slope] = targetResidual (problem, p, m);
  half = problem.tol ./ abs (slope(1, :));
  miss = abs (m - problem.value);
  noise = sqrt ([state.surrogates.noiseVar]);
  left = (half - miss) ./ sqrt (v + noise.^2);
  left(~problem.calibrate) = Inf;
  [~, t] = min (left);
  values = struct ('name', problem.targetNames{t}, 'expected', m(t), ...
                   'measured', problem.value(t), 'allowed', half(t), ...
                   'scatter', noise(t), 'sd', sqrt (v(t)), 'n', n);
  code = 'infill.unsure';
  if miss(t) > half(t)
    code = 'infill.miss';
  elseif noise(t) > half(t)
    code = 'infill.scatter';
  end
  text = sentence (code, values);
end

%!test
%! [problem, state] = smallCalibration ();
%! text = whyMore (state, problem, 6);
%! assert (! isempty (strfind (text, '6 more runs')));
%! for k = 1:numel (state.surrogates)
%!   state.surrogates(k).noiseVar = 100;
%! end
%! problem.value = predictSurrogate (state.surrogates, state.found.params);
%! assert (! isempty (strfind (whyMore (state, problem, 6), 'scatters by 10 a run')));

% SPDX-License-Identifier: GPL-3.0-only
