% CHECKLEFTOVERS  Faults of a model that has results before anything has run.
%
% CALL: P = checkLeftovers (NAME, LEFT)
%
%   NAME  of the model (text)
%   LEFT  k x 3 cell of texts: index, value and file of such a result (file: ''
%         where no file gives it), see leftoverResults
%   P     1 x n faults, see checkFault: one a file

function p = checkLeftovers (name, left)
  p = checkFault ();
  field = ['DEMmodels/', name, '/'];
  for file = unique (left(:, 3))'
    of = find (strcmp (left(:, 3), file{1}), 1);
    got = sprintf ('result %s is %s there', left{of, 1:2});
    if isempty (file{1})
      p(end + 1) = checkFault ('resultWithoutRun', ...
                               [field, 'OctaveFuns/getResults.m'], ...
                               'NaN where a run has left no output', got, ...
                               ['Let it return NaN where the file is ' ...
                                'missing: else a run that breaks off counts.']);
    else
      p(end + 1) = checkFault ('leftoverOutput', [field, file{1}], ...
                               'a model without the output of a run', ...
                               [got, ', before anything has run'], ...
                               ['Delete that file: each run would start with ' ...
                                'it, and one that breaks off would count.']);
    end
  end
end

%!assert (isempty (checkLeftovers ('M', cell (0, 3))))
%!test
%! p = checkLeftovers ('M', {'1', '4.29', 'out'; '2', '1.7', 'out'; ...
%!                           '3', '0', ''});
%! assert ({p.id}, {'DEcalioc:checkCase:resultWithoutRun', ...
%!                  'DEcalioc:checkCase:leftoverOutput'});
%! assert (strncmp (p(2).message, 'DEMmodels/M/out: expected', 25));
%! assert (~isempty (strfind (p(2).message, 'result 1 is 4.29')));

% SPDX-License-Identifier: GPL-3.0-only
