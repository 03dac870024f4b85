% OPENVERDICT  Turns evidences into probabilities, with no verdict yet.
%
% CALL: VERDICT = openVerdict (W, K)
%
%   W        struct of caseEvidence;  K  number of effects
%   VERDICT  struct of judgeCase, kind 'undecided'; also misfit (probability of
%            the discrepancies) and total (1 x K: include + resemble)
%
% See also: judgeCase

function verdict = openVerdict (w, K)
  logP = w.logPrior + w.logE;
  verdict = struct ('kind', 'undecided', 'effects', zeros (1, 0), ...
                    'lookAlike', false, 'partners', zeros (1, 0), ...
                    'guard', '', 'reason', 'no single cause is likely enough');
  verdict.P = exp (logP - logSumExp (logP));
  verdict.include = zeros (1, K);
  verdict.resemble = zeros (1, K);
  for h = 1:numel (verdict.P)
    at = w.members{h};
    if strcmp (w.kind{h}, 'sibling')
      verdict.resemble(at) = verdict.resemble(at) + verdict.P(h);
    else
      verdict.include(at) = verdict.include(at) + verdict.P(h);
    end
  end
  verdict.null = verdict.P(1);
  verdict.misfit = sum (verdict.P(strcmp (w.kind, 'discrepancy')));
  verdict.unlisted = verdict.misfit + sum (verdict.resemble);
  verdict.total = verdict.include + verdict.resemble;
  [~, verdict.top] = max ([verdict.total, 0]);
  [sorted, order] = sort (-verdict.total);
  whole = cumsum (-sorted);
  verdict.likely = order(1:find (whole >= 0.95 * max ([whole, realmin]), 1));
end

%!test
%! w = struct ('logPrior', log ([0.5, 0.3, 0.1, 0.1]), 'logE', zeros (1, 4));
%! w.kind = {'null', 'single', 'sibling', 'discrepancy'};
%! w.members = {[], 1, 1, []};
%! verdict = openVerdict (w, 1);
%! assert (verdict.total, 0.4, 1e-12);
%! assert ([verdict.include, verdict.unlisted], [0.3, 0.2], 1e-12);
%! assert (verdict.likely, 1);
