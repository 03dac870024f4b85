% FINGERPRINTS  The measured gap beside the one that each candidate would make.
%
% CALL: PRINTS = fingerprints (STUDY)
%
%   STUDY    struct gapProblem, em, models, fits, as of runCures
%   PRINTS  scalar struct: target 1 x n (numbers of the measured targets),
%           measured 1 x n (measured less simulated without any effect),
%           effects K x n (what each effect adds where it is fitted alone, the
%           parameters with it, to the measurements that are not held out)
%
% Both in standard deviations of the noise of a target: where two rows look
% alike, the two causes do.
%
% See also: diagnoseMatrices, writeGapJson

function prints = fingerprints (study)
  gapProblem = study.gapProblem;
  em = study.em;
  at = find (isfinite (gapProblem.value));
  sd = sqrt (diag (noiseBudget (gapProblem, em).covariance))';
  without = predictGap (em, [], study.fits.calibrated.Q(1, :));
  K = numel (study.models.names);
  prints = struct ('target', at, 'measured', ...
                   (gapProblem.value(at) - without(at)) ./ sd(at), ...
                   'effects', zeros (K, numel (at)));
  for k = 1:K
    fit = study.fits.of{study.models.singles(k)};
    with = predictGap (em, k, fit.Q(1, 1:em.p + 1));
    prints.effects(k, :) = (with(at) - without(at)) ./ sd(at);
  end
end

%!test
%! % the planted cause has the print of the gap, another one has not
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0, 0, 0.6, 0, 0]);
%! d = diagnoseMatrices (given, data, struct ('bootstrap', 49, 'trials', 0, ...
%!                                            'twins', 60));
%! P = d.fingerprint;
%! far = @(k) norm (P.effects(k, :) - P.measured) / norm (P.measured);
%! k = find (strcmp (d.screen.names, 'spread'));
%! assert (far (k) < 0.3);
%! assert (far (find (strcmp (d.screen.names, 'size'))) > 0.5);
