% Pages that tell a user what to type are followed literally: each block of
% commands is given to bash, in the order of the page. The blocks that calibrate
% or diagnose take minutes and are given only where DECALIOC_SOAK=1.

%!function blocks = commandsOf (page)
%!  % commands in the blocks of a page; those of a list are indented
%!  root = fileparts (fileparts (which ('startProgram')));
%!  text = fileread (fullfile (root, 'docs', page));
%!  found = regexp (text, '^ *```\n(.*?)\n *```', 'tokens', 'lineanchors');
%!  blocks = cellfun (@(t) t{1}, found, 'UniformOutput', false);
%!endfunction

%!function [status, out] = follow (folder, block)
%!  root = fileparts (fileparts (which ('startProgram')));
%!  script = sprintf (['set -e; export DECALIOC=%s PATH=%s:$PATH; cd %s\n' ...
%!                     '%s\n'], shellQuote (root), ...
%!                    shellQuote (fullfile (root, 'bin')), ...
%!                    shellQuote (folder), block);
%!  [status, out] = system (['bash -c ', shellQuote(script), ...
%!                           ' 2>&1 < /dev/null']);
%!endfunction

%!function yes = takesLong (block)
%!  yes = any (regexp (block, '^decalioc (run|diagnose)', 'lineanchors')) && ...
%!        ~strcmp (getenv ('DECALIOC_SOAK'), '1');
%!endfunction

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! folder = fullfile (tempname (), 'a user''s');
%! mkdir (folder);
%! blocks = commandsOf ('quickstart.md');
%! assert (numel (blocks) >= 10);
%! assert (strncmp (blocks{1}, 'make setup', 10));   % what tests stand on
%! for block = blocks(2:end)
%!   if ~takesLong (block{1})
%!     [status, out] = follow (folder, block{1});
%!     assert (status, 0, [block{1}, "\n", out]);
%!   end
%! end
%! case_ = fullfile (folder, 'Repose');
%! head = headDefaults (fullfile (case_, 'DEMmodels', 'Repose', 'data.head'));
%! assert (head.plateRadius, 0.035);
%! text = fileread (fullfile (case_, 'loadInput.m'));
%! assert (~isempty (strfind (text, '[29.2, 0.0131, 0.0180]')));
%! % runs of the model as it was are left aside
%! [~, out] = follow (folder, 'decalioc status Repose');
%! assert (~isempty (strfind (out, 'left aside')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fileparts (folder), 's');

% --- extend.md: the model Slump by hand, then its table of runs
%!function text = blockAfter (text, mark)
%!  from = strfind (text, mark);
%!  text = regexp (text(from(1):end), '```\w*\n(.*?)```', 'tokens', 'once'){1};
%!endfunction

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! root = fileparts (fileparts (which ('startProgram')));
%! text = fileread (fullfile (root, 'docs', 'extend.md'));
%! folder = tempname ();
%! model = fullfile (folder, 'DEMmodels', 'Slump');
%! mkdir (fullfile (model, 'OctaveFuns'));
%! files = {'**1. `data.head`', 'data.head'; '**2. `in.Slump`', 'in.Slump'; ...
%!          '**3. `runscript`', 'runscript'; ...
%!          '**4. `OctaveFuns', 'OctaveFuns/getResults.m'; ...
%!          '**6. Name it', '../../loadInput.m'; ...
%!          '**In four fields', '../../loadEffects.m'};
%! for k = 1:rows (files)
%!   writeAtomic (fullfile (model, files{k, 2}), ...
%!                blockAfter (text, files{k, 1}));
%! end
%! [status, out] = follow (folder, 'decalioc check --try');
%! assert (status, 0, out);
%! assert (~isempty (strfind (out, 'trial     Slump: ok')), out);
%! assert (~isempty (strfind (out, 'effects   bounce')), out);
%! writeAtomic (fullfile (folder, 'runs.csv'), ...
%!              blockAfter (text, '## Runs that exist already'));
%! [status, out] = follow (folder, 'decalioc check');
%! assert (~isempty (strfind (out, 'runs.csv  2 sets taken in')), out);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% --- the reading functions of extend.md are there and have the call shown
%!test
%! root = fileparts (fileparts (which ('startProgram')));
%! text = fileread (fullfile (root, 'docs', 'extend.md'));
%! from = strfind (text, '### Reading particle dumps');
%! part = text(from:from + strfind (text(from:end), "\n### Rules")(1));
%! names = regexp (part, '^\| `(?:[^=`]*= )?(\w+) \(', 'tokens', 'lineanchors');
%! names = unique ([names{:}]);
%! assert (numel (names) >= 10);
%! for name = names
%!   assert (exist (name{1}), 2, name{1});
%! end
%! % the lines below the table run on the sample of a bench
%! code = blockAfter (part, '```octave');
%! folder = [tempname(), '/'];
%! mkdir (folder);
%! copyfile (fullfile (root, 'DEMmodels', 'Heap', 'sample', 'heap.dump'), ...
%!           folder);
%! eval (code);
%! assert (isfile ([folder, 'measured.svg']));
%! assert (inBox > 0 && angle > 20 && angle < 40);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
