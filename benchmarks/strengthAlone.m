% STRENGTHALONE  Median and 90 % interval of an effect where it acts alone.
%
% CALL: Q = strengthAlone (EVIDENCE, MODELS, K)
%
%   EVIDENCE, MODELS  see caseEvidence
%   K          number of the effect in the list of MODELS
%   Q          1 x 3: median, both ends; NaN where it was not integrated

function q = strengthAlone (evidence, models, k)
  q = NaN (1, 3);
  row = models.singles(k);
  sample = evidence.posterior{row};
  if ~isempty (sample.Q)
    effect = models.white.effect(k);
    q = strengthInterval (sample.Q(:, models.white.p + 1), sample.cautious, ...
                          effect.range, effect.scale);
    q(1) = evidence.phi(row);
  end
end

%!test
%! pkg load stk
%! [given, data] = smallGapLab ();
%! options = gapOptions ([]);
%! given.value = mean (data.Z);
%! problem = newProblem (given);
%! models = makeHypotheses (problem, fitEmulator (problem, data, options), ...
%!                          options);
%! models = gapReference (models);
%! evidence = caseEvidence (models, fitLibrary (models, given.value), 1);
%! q = strengthAlone (evidence, models, 1);
%! assert (q(2) <= q(1) && q(1) <= q(3));
%! assert (q(1), evidence.phi(models.singles(1)));
