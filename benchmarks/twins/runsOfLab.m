% RUNSOFLAB  Further runs of a foreign laboratory, as diagnoseMatrices asks.
%
% CALL: RUNS = runsOfLab (RUN, GIVEN, KEPT)
%
%   RUN    handle Z = RUN (THETA, PHI) of foreignLab
%   GIVEN  its problem, with the effects KEPT (1 x k, numbers) alone
%   KEPT   default: all
%   RUNS   handle Z = RUNS (X, E, ...), parameters and values of the effects
%
% See also: foreignLab, planStudy

function runs = runsOfLab (run, given, kept)
  given.value = zeros (size (given.sd));
  effects = newProblem (given).effects;
  if nargin < 3
    kept = 1:numel (effects);
  end
  low = given.limits(1, :);
  among = eye (max ([kept, numel(effects)]))(kept, :);
  runs = @(X, E, varargin) run ((X - low) ./ diff (given.limits), ...
                                strengthOfValues (effects, E) * among);
end

%!test
%! lab = foreignLab ('develop', 1);
%! K = numel (lab.problem.effects);
%! p = columns (lab.problem.limits);
%! runs = runsOfLab (@(theta, phi) [theta, phi], lab.problem);
%! dem = lab.problem.effects(~[lab.problem.effects.laboratory]);
%! Z = runs (mean (lab.problem.limits), [dem.neutral], 1, 'gap');
%! assert (Z, [0.5 * ones(1, p), zeros(1, K)], 1e-12);
