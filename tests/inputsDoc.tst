% The pages and the checks name the same faults and the same fields.

%!function names = inTable ()
%!  text = fileread (fullfile (rootOf (), 'docs', 'identifiers.md'));
%!  text = text(strfind (text, "| reason |"):strfind (text, '## Others'));
%!  names = {};
%!  for row = strsplit (text, "\n")
%!    if strncmp (row{1}, '| `', 3)
%!      cells = strsplit (row{1}, '|');
%!      found = regexp (cells{2}, '`(\w+)`', 'tokens');
%!      names = [names, found{:}];
%!    end
%!  end
%!endfunction

%!function folder = rootOf ()
%!  folder = fileparts (fileparts (which ('startToolbox')));
%!endfunction

%!test
%! % every reason of the bad inputs stands in the table, and the other way round
%! reasons = unique ([badInputs()(:, 1); badEffects()(:, 1)])';
%! assert (isempty (setdiff (reasons, inTable ())));
%! % (checkShadow tests its own: the file would stand in the way of the others)
%! untested = setdiff (inTable (), [reasons, {'checkFailed', 'shadow'}]);
%! assert (isempty (untested), strjoin ([untested, {''}], ' '));

%!test
%! % every reason that the code names stands in the table
%! names = {};
%! for file = glob (fullfile (rootOf (), 'infrastructure', ...
%!                            {'case', 'case/check', 'case/check/private', ...
%!                             'effects', 'effects/private'}, '*.m'))'
%!   found = regexp (fileread (file{1}), ...
%!                   'checkFault \(''(\w+)''', 'tokens');
%!   names = [names, found{:}];
%! end
%! names = setdiff (names, {'badCpu', 'a'});
%! assert (numel (names) > 40);
%! assert (all (ismember (names, inTable ())), ...
%!         strjoin (setdiff (names, inTable ()), ' '));

%!test
%! % the fields of Input and optim stand on the page as their table has them
%! % (make index); those of an effect are described
%! addpath (fullfile (rootOf (), 'tools'));
%! text = fileread (fullfile (rootOf (), 'docs', 'inputs.md'));
%! assert (strcmp (text, inputLines (text)));
%! folder = tempname ();
%! raw = goodInput (folder);
%! fields = fieldnames (raw.effects)';
%! isThere = cellfun (@(f) ! isempty (regexp (text, ['`', f, '[`{(]'])), ...
%!                    fields);
%! assert (all (isThere), strjoin (fields(! isThere), ' '));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
