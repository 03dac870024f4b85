% CASELABELS  Names of the cases that made the runs of a store, for the user.
%
% CALL: LABELS = caseLabels (KINDS)
%
%   KINDS   1 x K struct array, see readLibrary
%   LABELS  1 x K cell: the folder of the case, with the first digits of its id
%           (caseId) where several cases were at that folder, as in containers

function labels = caseLabels (kinds)
  labels = {kinds.origin};
  for origin = unique (labels)
    at = find (strcmp ({kinds.origin}, origin{1}));
    if numel (unique ({kinds(at).owner})) > 1
      for k = at(~cellfun (@isempty, {kinds(at).owner}))
        labels{k} = sprintf ('%s (case %.8s)', origin{1}, kinds(k).owner);
      end
    end
  end
  % others write them: no control character reaches the terminal
  labels = regexprep (labels, '[\x00-\x1f\x7f]', '?');
end

%!test
%! kinds = struct ('origin', {'/a', '/case', '/case', '/case'}, ...
%!                 'owner', {'0123456789', 'abcdefghij', 'bcdefghijk', ''});
%! assert (caseLabels (kinds), {'/a', '/case (case abcdefgh)', ...
%!                              '/case (case bcdefghi)', '/case'});
%! assert (caseLabels (kinds([])), {});
%! kinds(1).origin = "/a\n\x1b[2J";
%! assert (caseLabels (kinds(1)), {'/a??[2J'});

% SPDX-License-Identifier: GPL-3.0-only
