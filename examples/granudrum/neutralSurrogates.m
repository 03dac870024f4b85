% NEUTRALSURROGATES  Kriging of the null model's surfaces over the parameters.
%
% CALL: [SURROGATES, PROBLEM, DATA] = neutralSurrogates (CASE, OWN)
%
%   CASE        see newCase, with effects
%   OWN         1 x T logical, the targets that count as measured
%   SURROGATES  1 x T struct array of fitSurrogates, of all targets
%   PROBLEM     struct of newProblem, with the targets of OWN alone
%   DATA        the runs without effects that gave all results, see gatherRuns;
%               of a case with levels those of the last one (the surrogates
%               hold all)
%
% See also: drawPredictionSets

function [surrogates, problem, data] = neutralSurrogates (Case, own)
  data = gatherRuns (Case);
  v = numel (Case.coarse);
  neutral = neutralEffects (Case);
  plain = all (data.E(:, v + 1:end) == neutral(v + 1:end), 2) & ...
          all (isfinite (data.Z), 2);
  E = data.E(plain, 1:v);
  data = addRows (newData (numel (Case.names), numel (Case.targets), v), ...
                  data.X(plain, :), data.Z(plain, :), ...
                  data.replicate(plain), 'import', E);
  surrogates = fitSurrogates (data, newProblem (Case, []));
  data = keepRows (data, all (E == neutral(1:v), 2));
  Case.targets = Case.targets(own);
  problem = newProblem (Case, []);
end

% SPDX-License-Identifier: GPL-3.0-only
