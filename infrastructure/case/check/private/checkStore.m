% CHECKSTORE  Checks that the runs can be kept: folders and free space.
%
% CALL: P = checkStore (STORE, FOLDER, MODELS, NRUNS)
%
%   STORE   folder that keeps the runs (text); need not exist yet
%   FOLDER  case folder (text)
%   MODELS  1 x M struct array, see checkFindModels
%   NRUNS   number of runs of each model that may be made
%   P       1 x n faults, see checkFault
%
% Space needed: 20 MB, and for each run the size of the model's folder and
% 0.1 MB of output.

function p = checkStore (store, folder, models, nRuns)
  there = existing (store);
  above = existing (folder);
  sizes = {models(~cellfun (@isempty, {models.folder})).folder};
  inside = fullfile (store, 'optim', [{''}, {models.name}]);
  inside = inside(isfolder (inside));
  [isOpen, free, used, isKept] = ask ([{above, there}, inside], sizes);
  need = 20 + nRuns * (used + 0.1 * numel (models));
  p = [checkFolder(above, isOpen(1), ['The case folder ', folder], ...
                   'folderNotWritable', 'Start in a folder of your own.'), ...
       checkFolder([{there}, inside]{[find(~isOpen(2:end), 1), 1](1)}, ...
                   all (isOpen(2:end)), 'Input.store', 'storeNotWritable', ...
                   ['Correct its permissions (of a group: ' ...
                    'docs/next-material.md), or set another Input.store.'])];
  own = [{fullfile(store, 'optim')}, fullfile(folder, {'KrigingFuns', 'results', 'gap'})];
  own = own(cellfun (@(place) ~isempty (lstat (place)) && ~isfolder (place), own));
  if any (folder == pathsep ())
    p = checkFault ('badFolder', ['The case folder ', folder], ...
                    ['a path without a colon, which parts the folders of ' ...
                     'the path of Octave'], 'one with it', ...
                    'Rename the folder.');
  elseif ~isempty (p)
    p = p(1);
  elseif ~isempty (own)
    p = checkFault ('badStore', own{1}, 'a folder, which DEcalioc makes', ...
                    'a file, or a link that leads nowhere', ...
                    'Move it away, or mount the disk of the link.');
  elseif isKept
    p = checkFault ('storeUmask', 'Input.store', ...
                    'new folders in which its group may write, too', ...
                    'a umask that keeps the group out', ...
                    ['Say umask 002 before the start, or give the store a ' ...
                     'default ACL (docs/next-material.md).']);
  elseif free < need
    p = checkFault ('diskSpace', 'Input.store', ...
                    sprintf ('%.0f MB of free space in %s for %d runs', ...
                             need, there, nRuns), ...
                    sprintf ('%.0f MB', free), ...
                    ['Free some space, set Input.store to another disk, ' ...
                     'or lower Input.numOfSam.']);
  end
end

function p = checkFolder (there, isOpen, field, reason, cure)
  p = checkFault ();
  if ~isfolder (there)
    p = checkFault ('badStore', field, 'a folder', ['the file ', there], cure);
  elseif ~isOpen
    p = checkFault (reason, field, 'a folder that can be written to', ...
                    ['no permission for ', there], cure);
  end
end

% The folder itself, or the nearest one above that is there.
function folder = existing (folder)
  folder = make_absolute_filename (folder);
  while ~isfolder (folder) && ~isfile (folder) && ~strcmp (folder, '/')
    folder = fileparts (folder);
  end
end

% Asks the shell once: which FOLDERS can be written to (only trying tells: root
% may write anywhere but on a read-only disk), how much is free in the last one
% and how much the folders MODELS hold (MB). ISKEPT: the second is that of a
% group (setgid), into whose new folders only their owner could write.
function [isOpen, free, used, isKept] = ask (folders, models)
  quoted = strjoin (cellfun (@shellQuote, folders, ...
                             'UniformOutput', false), ' ');
  command = ['LC_ALL=C; export LC_ALL; for d in ', quoted, '; do ' ...
             't=$(mktemp "$d/.decalioc.XXXXXX") && rm -f -- "$t" && ' ...
             'echo open || echo shut; done; df -Pk "$d" | tail -n 1; ' ...
             's=', shellQuote(folders{2}), '; case $(stat -c %A "$s") in ' ...
             'd????w[sS]*) t=$(mktemp -u "$s/.decalioc.XXXXXX") && ' ...
             'mkdir "$t" && case $(stat -c %A "$t") in d????w*) ;; ' ...
             '*) echo kept;; esac; rmdir "$t";; esac; '];
  for k = 1:numel (models)
    command = [command, 'du -skL --apparent-size ', ...
               shellQuote(models{k}), '; '];
  end
  [~, out] = system (['{ ', command, ' } 2> /dev/null']);
  isOpen = strcmp (regexp (out, '^(open|shut)$', 'match', ...
                           'lineanchors'), 'open');
  isOpen(end + 1:numel (folders)) = true;
  isKept = ~isempty (regexp (out, '^kept$', 'once', 'lineanchors'));
  free = Inf;
  found = regexp (out, '(\d+)\s+\d+%\s+/', 'tokens', 'once');
  if ~isempty (found)
    free = str2double (found{1}) / 1024;
  end
  % without a model there is no size: str2double ([]) would be NaN
  found = regexp (out, '^\d+(?=\t)', 'match', 'lineanchors');
  used = sum (str2double (found)) / 1024;
end

%!shared none
%! none = struct ('name', cell (1, 0), 'folder', '');
%!assert (isempty (checkStore (tempname (), tempdir (), none, 1)))
%!test
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'KrigingFuns'), "x\n");
%! assert (checkStore (folder, folder, none, 1).id, 'DEcalioc:checkCase:badStore');
%!test
%! % the runs lie on another disk, which is not mounted, or is
%! folder = emptyFolder ();
%! symlink (fullfile (folder, 'disk'), fullfile (folder, 'optim'));
%! assert (checkStore (folder, folder, none, 1).id, 'DEcalioc:checkCase:badStore');
%! mkdir (fullfile (folder, 'disk'));
%! assert (isempty (checkStore (folder, folder, none, 1)));
%!assert (checkStore (tempname (), '/tmp/a:b', none, 1).id, ...
%!        'DEcalioc:checkCase:badFolder')
%!test
%! model = struct ('name', 'M', 'folder', fileparts (which ('checkStore')));
%! p = checkStore (tempname (), tempdir (), model, 1e15);
%! assert (p.id, 'DEcalioc:checkCase:diskSpace');
%! % a model that was not found: the output of its runs counts all the same
%! p = checkStore (tempname (), tempdir (), struct ('name', 'M', 'folder', ''), 1e15);
%! assert (p.id, 'DEcalioc:checkCase:diskSpace');
%!test
%! file = tempname ();
%! writeAtomic (file, '');
%! p = checkStore (fullfile (file, 'x'), tempdir (), none, 1);
%! assert (p.id, 'DEcalioc:checkCase:badStore');
%!assert (checkStore ('/proc/x', tempdir (), none, 1).id, ...
%!        'DEcalioc:checkCase:storeNotWritable')
%!test
%! % a store of a group: what a umask makes of its new folders
%! store = emptyFolder ();
%! before = umask (22);
%! back = onCleanup (@() umask (before));
%! assert (isempty (checkStore (store, tempdir (), none, 1)));
%! system (['chmod 2775 ', store]);
%! assert (checkStore (store, tempdir (), none, 1).id, ...
%!         'DEcalioc:checkCase:storeUmask');
%! umask (2);
%! assert (isempty (checkStore (store, tempdir (), none, 1)));

% SPDX-License-Identifier: GPL-3.0-only
