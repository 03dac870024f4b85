% STRENGTHERRORS  What the strengths of a change are off by, in parts.
%
% CALL: ERRORS = strengthErrors (STUDY, EVIDENCE)
%
%   STUDY     struct problem, emulator of newProblem, emulateChange
%   EVIDENCE  of caseEvidence
%   ERRORS    1 x K struct, in the units of the measured values; T targets: phi (the
%             strength), gain (1 x T: what a target that is read higher adds to it),
%             own, shared, form (T x T covariances: of the condition's readings; of the
%             reference, of what the model lacks, and of the parameters that both
%             conditions have; of the surrogate of the effect and of its form, at PHI).
%             Of no change, or an effect that was not integrated, gain is []
%
% Two conditions are compared with one reference, by one surrogate of the effect:
% what these are off by moves both strengths alike (compareConditions).

function errors = strengthErrors (study, evidence)
  K = numel (study.emulator.effect);
  errors = repmat (struct ('phi', NaN, 'gain', [], 'own', [], 'shared', [], 'form', []), ...
                   1, K * ~isempty (study.emulator.change));
  for k = 1:numel (errors)
    h = find (cellfun (@(m) isequal (m, k), evidence.members), 1);
    if ~isempty (h) && ~isempty (evidence.posterior{h}.Q)
      errors(k) = errorsOf (study, k, evidence.posterior{h});
    end
  end
end

function errors = errorsOf (study, k, posterior)
  [problem, emulator] = deal (study.problem, study.emulator);
  used = problem.used;
  q = posterior.weight' * posterior.Q(:, 1:emulator.p + 1);
  mark = predictGap (emulator, k, q) - predictGap (emulator, [], q(1:end - 1));
  errors.phi = q(end);
  u = mark(used)' / q(end);
  J = slopesAt (emulator, k, q)(:, used)';
  same = ~problem.reference.perCondition;
  change = emulator.change;
  % of a flat prior on [-1, 1], and what the reference says
  known = emulator.known.root' * emulator.known.root + 3 * eye (emulator.p);
  shared = change.covariance(used, used) - change.fresh(used, used) + ...
           J(:, same) * (known(same, same) \ J(:, same)');
  own = change.fresh(used, used) + J(:, ~same) * J(:, ~same)' / 3;
  % a turned law does something of its own, as large as the tangent of the angle says
  marks = mark(used)' ./ sqrt (diag (own));
  strange = posterior.weight' * posterior.Q(:, end).^2 * sumsq (marks) / numel (used);
  form = effectError (emulator, k, q)(used, used) + strange * diag (diag (own));
  C = own + shared + form;
  g = C \ u / (u' * (C \ u));
  T = numel (problem.value);
  unit = problem.unit(used);
  errors.gain = zeros (1, T);
  errors.gain(used) = g' ./ unit;
  for part = {'own', own; 'shared', shared; 'form', form}'
    errors.(part{1}) = zeros (T);
    errors.(part{1})(used, used) = part{2} .* (unit' * unit);
  end
end

function J = slopesAt (emulator, k, q)
  J = zeros (emulator.p, columns (emulator.coef));
  for j = 1:emulator.p
    [lo, hi] = deal (q);
    [lo(j), hi(j)] = deal (q(j) - 0.05, q(j) + 0.05);
    J(j, :) = diff (predictGap (emulator, k, [lo; hi]), 1, 1) / 0.1;
  end
end

%!test
%! % one target, a reference known to 3, a reading as sure as 4, a mark of 10
%! e = struct ('name', 'a', 'powers', [0, 1], 'coef', 10, 'bend', 1, 'misfit', 0, ...
%!             'root', zeros (1, 0), 'ofTarget', zeros (0, 1), 'unbent', 0, ...
%!             'strongest', 1);
%! emulator = handMadeEmulator ([0; 0]);
%! [emulator.noiseVar, emulator.range] = deal (1e-9, 1e-3);
%! given = struct ('value', 5, 'sd', 4, 'trials', Inf, 'limits', [0; 1], 'bench', 1);
%! given.reference = struct ('value', 0, 'sd', 3, 'trials', Inf, 'scatter', false, ...
%!                           'perCondition', false);
%! study.problem = newProblem (given);
%! emulator = emulateChange (emulator, study.problem);
%! % of a model without any lack the reference would be forgotten
%! emulator.change.covariance = 25;
%! emulator.effect = e;
%! study.emulator = emulator;
%! evidence = struct ('members', {{[], 1}});
%! evidence.posterior = {struct('Q', []), struct('Q', [0, 0.5, 0], 'weight', 1)};
%! errors = strengthErrors (study, evidence);
%! assert ({errors.phi, errors.gain, errors.own, errors.shared, errors.form}, ...
%!         {0.5, 0.1, 16, 9, 0}, 1e-6);
%! study.emulator.change = [];
%! assert (isempty (strengthErrors (study, evidence)));

% SPDX-License-Identifier: GPL-3.0-only
