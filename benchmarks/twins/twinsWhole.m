% TWINSWHOLE  Diagnoses twins the whole way: with new runs of their laboratory.
%
% CALL: VERDICTS = twinsWhole (KIND, LABS, TWINS, NUMBERS, SETS, PLACE)
%
%   KIND      'blind' or 'develop', of foreignLab
%   LABS      of foreignLaboratories; gapProblem and data (runs that there are
%             already) are used
%   TWINS     1 x n struct of twinsDraw; lab and y are looked at
%   NUMBERS   1 x n, of the cases: seeds of the new runs, names of the records
%   SETS      new parameter sets that a diagnosis may run, those of its cures
%             among them
%   PLACE     char, existing folder of the verdicts made so far: one that is
%             there is not made again
%   VERDICTS  1 x n struct, see twinsDiagnose; P holds no pairs (NaN)
%
% A job of foreignTwins. As in the product, new runs go to the likely effects,
% to the likeliest pair and to the cures, whose runs enter the verdict.
%
% See also: twinsOfLab, diagnoseMatrices

function verdicts = twinsWhole (kind, labs, twins, numbers, sets, place)
  pkg ('load', 'stk');
  for i = 1:numel (twins)
    record = fullfile (place, sprintf ('%d.txt', numbers(i)));
    if ~exist (record, 'file')
      lab = labs(twins(i).lab);
      verdict = diagnoseOne (foreignLab (kind, twins(i).lab), lab, ...
                             twins(i), numbers(i), sets);
      save ('-text', [record, '.part'], 'verdict');
      rename ([record, '.part'], record);
    end
    verdicts(i) = load (record).verdict;
  end
end

function verdict = diagnoseOne (source, lab, twin, number, sets)
  start = tic ();
  rand ('twister', 90000 + number);
  randn ('twister', 90000 + number);
  options = struct ('maxNewRuns', sets, 'bootstrap', 99);
  given = setfield (lab.gapProblem, 'value', twin.y);
  effects = newProblem (given).effects;
  runs = runsOf (source, lab.gapProblem, effects);
  d = diagnoseMatrices (given, lab.data, options, runs);
  verdict = verdictOf (d.which, {effects.name}, toc (start));
end

function runs = runsOf (source, gapProblem, effects)
  low = gapProblem.limits(1, :);
  width = diff (gapProblem.limits);
  runs = @(X, E, varargin) source.run ((X - low) ./ width, ...
                                       strengthOfValues (effects, E));
end

function v = verdictOf (verdict, names, seconds)
  K = numel (names);
  [~, effects] = ismember (verdict.effects, names);
  [~, partners] = ismember (verdict.partners, names);
  v = struct ('kind', verdict.verdict, 'effects', effects, ...
              'lookAlike', verdict.lookAlike, 'guard', verdict.guard, ...
              'partners', partners, 'top', 1, ...
              'P', [verdict.posterior.null, zeros(1, K), NaN, ...
                    verdict.posterior.unlisted], ...
              'total', zeros (1, K), 'interval', NaN (K, 3), ...
              'gateP', verdict.gateP, ...
              'ess', verdict.numbers.ess, 'seconds', seconds);
  for k = 1:K
    if isfield (verdict.posterior, names{k})
      v.P(1 + k) = verdict.posterior.(names{k});
      v.total(k) = v.P(1 + k);
    end
    listed = find (strcmp ({verdict.strength.name}, names{k}), 1);
    if ~isempty (listed)
      strength = verdict.strength(listed);
      v.interval(k, :) = [strength.value, strength.interval90];
    end
  end
  [~, v.top] = max (v.total);
end
