% LIKELYKINDS  Hypotheses among which a further measurement could tell.
%
% CALL: [KEEP, P, KINDS, NAMES] = likelyKinds (EVIDENCE, P, HYPOTHESES)
%
%   EVIDENCE  struct of caseEvidence (members, posterior, kind)
%   P        1 x H, probabilities of the hypotheses
%   HYPOTHESES  scalar struct: names (1 x K cell, of the effects), options (see
%            gapOptions)
%   KEEP     1 x h, hypotheses of more than 0.005 of what is listed, which no
%            discrepancy is, and that have a posterior; P their probabilities,
%            of sum 1
%   KINDS    1 x h, kind of cause of each, likeliest first: those with the same
%            members are of one kind
%   NAMES    1 x c cell, name of each kind: 'cohesion', 'cohesion + drag',
%            'no gap'
%
% Where the kind is open by less than options.adviseAt (bits), all are of one
% kind: nothing is left to ask.
%
% Where only misfits of no shape are likely, the likeliest of the others stays:
% nothing is left to tell.

function [keep, P, kinds, names] = likelyKinds (evidence, P, hypotheses)
  listed = ~strcmp (evidence.kind, 'discrepancy');
  listed = find (listed & ~cellfun (@(p) isempty (p.Q), evidence.posterior));
  P = P / max (sum (P(listed)), realmin);
  % what is less likely adds next to nothing to the information
  keep = listed(P(listed) > 0.005);
  if isempty (keep)
    [~, best] = max (P(listed));
    keep = listed(best);
    P(keep) = 1;
  end
  P = P(keep) / sum (P(keep));
  % the same effects in any order are one kind
  texts = cellfun (@(m) mat2str (sort (m)), evidence.members(keep), ...
                   'UniformOutput', false);
  [~, first, kinds] = unique (texts, 'first');
  kinds = reshape (kinds, size (keep));
  weight = accumarray (kinds(:), P(:));
  [~, order] = sort (-weight);
  rank(order) = 1:numel (order);
  kinds = rank(kinds);
  names = cell (1, numel (order));
  for c = 1:numel (order)
    members = evidence.members{keep(first(order(c)))};
    names{c} = strjoin (hypotheses.names(members), ' + ');
    if isempty (members)
      names{c} = 'no gap';
    end
  end
  least = hypotheses.options.adviseAt;
  % no measurement can tell more bits than are open
  if entropyOf (P, kinds) < least
    kinds(:) = 1;
    names = names(1);
  end
end

function bits = entropyOf (P, kinds)
  weight = accumarray (kinds(:), P(:));
  weight = weight(weight > 0);
  bits = -sum (weight .* log2 (weight));
end

%!test
%! hypotheses = struct ('names', {{'a', 'b'}}, 'options', gapOptions ([]));
%! evidence.kind = {'null', 'single', 'pair', 'pair', 'discrepancy', 'single'};
%! evidence.members = {[], 1, [2, 1], [1, 2], [], 2};
%! evidence.posterior = repmat ({struct('Q', 1)}, 1, 6);
%! P = [0.05, 0.2, 0.1, 0.2, 0.4, 0.05];
%! [keep, P, kinds, names] = likelyKinds (evidence, P, hypotheses);
%! assert (keep, [1, 2, 3, 4, 6]);
%! assert (P, [1, 4, 2, 4, 1] / 12, 1e-12);
%! assert (kinds([3, 4]), [1, 1]);
%! assert (names([1, 2]), {'b + a', 'a'});
%! assert (sort (names(3:4)), {'b', 'no gap'});
%! % the kind is known
%! [~, ~, kinds, names] = likelyKinds (evidence, [0, 0.99, 0, 0, 0, 0.01], hypotheses);
%! assert ({kinds, names}, {[1, 1], {'a'}});
%! [keep, P] = likelyKinds (evidence, [0, 0, 0, 0, 1, 0], hypotheses);
%! assert (numel (keep), 1);
%! assert (P, 1);

% SPDX-License-Identifier: GPL-3.0-only
