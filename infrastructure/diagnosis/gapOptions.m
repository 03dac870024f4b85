% GAPOPTIONS  Fills the options of a diagnosis with their defaults.
%
% CALL: OPTIONS = gapOptions (GIVEN)
%
%   GIVEN    struct with any of the fields ([] = all defaults)
%   OPTIONS  struct with all of them, and those of gapConstants
%     seed         random numbers start here (1)
%     points       first draw of each integral (400), effective points wanted
%                  (400) and most points drawn (12000): points, effective, most
%     leastPoints  effective points below which no number is believed (200: an
%                  error of 0.07 in the logarithm of the evidence)
%     bootstrap    repetitions of the fit test (999)
%     twins        twins without a gap, drawn from the surrogates, that the gate
%                  compares with (400)
%     covariance   of the baseline Kriging ('matern52'; 'choose' tries more)
%     trend        of the same ('choose')
%     maxNewRuns   parameter sets that the diagnosis may run in all (0)
%     explore      make runs before the verdict (true); without, only those that
%                  verify a cure
%     neutral      sets without an effect that a case runs first, for each
%                  parameter and one (4: fewer make most surrogates vague, and
%                  where four are too few runs that mend them are added)
%     batch        runs between two looks at the evidence (5: fewer cost more
%                  fits, more are chosen on older knowledge)
%     verifyRuns   seeds at each compared set when the cure is checked (5)
%     significance  chance of a false alarm (0.05)
%     seekAt       p of the gate below which it is doubtful that there is no gap
%                  (0.5)
%     surplus      variance of data without a gap over what the budget says
%                  (1.15; at 1 laboratories of formulas alarm in 9 %)
%     caution      power of the likelihood in intervals of strengths (0.4: at 1
%                  they hold that of laboratories of other laws in 66 % where
%                  they should in 90 %; closed study intervalCaution.m)
%     othersAt     share of a named effect's probability that none may have that
%                  explains the data without it (0.1)
%     adviseAt     bits about the kind of cause below which no measurement is
%                  advised, and none sought (0.2: a yes or no that is right in
%                  three of four cases)
%
% See also: diagnoseMatrices, judgeCase, gapConstants

function options = gapOptions (given)
  options = struct ('seed', 1, 'points', 400, 'effective', 400, ...
                    'most', 12000, 'leastPoints', 200, 'bootstrap', 999, ...
                    'twins', 400, 'covariance', 'matern52', 'trend', ...
                    'choose', 'maxNewRuns', 0, 'explore', true, 'neutral', 4, ...
                    'batch', 5, 'verifyRuns', 5, 'significance', 0.05, 'seekAt', 0.5, ...
                    'surplus', 1.15, 'caution', 0.4, 'othersAt', 0.1, ...
                    'adviseAt', 0.2);
  options = mergeFields (gapConstants (), options);
  if isstruct (given)
    options = mergeFields (options, given);
  end
end

%!assert (gapOptions ([]).significance, 0.05)
%!assert (gapOptions (struct ('twins', 7)).twins, 7)
%!test
%! % all that a diagnosis reads is there, each once
%! assert (numel (fieldnames (gapOptions ([]))), 53);

% SPDX-License-Identifier: GPL-3.0-only
