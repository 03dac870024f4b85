% CHECKSTORE  Checks that the runs can be kept: folders and free space.
%
% CALL: P = checkStore (STORE, FOLDER, MODELS, NRUNS)
%
%   STORE   folder that keeps the runs (text); need not exist yet
%   FOLDER  case folder (text)
%   MODELS  1 x M struct array, see checkFindModels
%   NRUNS   number of runs of each model that may be made
%   P       1 x n problems, see checkProblem
%
% Space needed: 20 MB, and for each run the size of the model's folder and
% 0.1 MB of output.
%
% Reasons: badStore storeNotWritable folderNotWritable diskSpace
%
% See also: checkCase

function p = checkStore (store, folder, models, nRuns)
  p = checkFolder (folder, ['The case folder ', folder], ...
                   'folderNotWritable', ...
                   'Start in a folder of your own, or correct its permissions.');
  q = checkFolder (store, 'Input.store', 'storeNotWritable', ...
                   'Correct its permissions, or set another Input.store.');
  if isempty (p)
    p = [p, q];
  end
  if ~isempty (p)
    return
  end
  free = freeSpace (existing (store));
  need = 20 + nRuns * sum (folderSizes (models) + 0.1);
  if free < need
    p = checkProblem ('diskSpace', 'Input.store', ...
                      sprintf ('%.0f MB of free space in %s for %d runs', ...
                               need, existing (store), nRuns), ...
                      sprintf ('%.0f MB', free), ...
                      ['Free some space, set Input.store to another disk, ' ...
                       'or lower Input.numOfSam.']);
  end
end

function p = checkFolder (folder, field, reason, cure)
  p = checkProblem ();
  there = existing (folder);
  if ~isfolder (there)
    p = checkProblem ('badStore', field, 'a folder', ...
                      sprintf ('the file %s', there), cure);
  elseif ~isWritable (there)
    p = checkProblem (reason, field, 'a folder that can be written to', ...
                      sprintf ('no permission for %s', there), cure);
  end
end

% Only trying tells: root may write anywhere but on a read-only disk.
function yes = isWritable (folder)
  command = ['t=$(mktemp ', shellQuote(fullfile (folder, '.decalioc.XXXXXX')), ...
             ' 2> /dev/null) && rm -f -- "$t"'];
  yes = system (command) == 0;
end

% The folder itself, or the nearest one above that is there.
function folder = existing (folder)
  folder = make_absolute_filename (folder);
  while ~isfolder (folder) && ~isfile (folder) && ~strcmp (folder, '/')
    folder = fileparts (folder);
  end
end

function free = freeSpace (folder)
  free = Inf;
  [status, out] = system (['LC_ALL=C df -Pk ', shellQuote(folder), ...
                           ' 2> /dev/null']);
  found = regexp (out, '(\d+)\s+\d+%\s+/', 'tokens');
  if status == 0 && ~isempty (found)
    free = str2double (found{1}{1}) / 1024;
  end
end

function sizes = folderSizes (models)
  sizes = zeros (1, numel (models));
  for k = find (~cellfun (@isempty, {models.folder}))
    [status, out] = system (['du -skL --apparent-size ', ...
                             shellQuote(models(k).folder), ' 2> /dev/null']);
    if status == 0
      sizes(k) = str2double (strtok (out)) / 1024;
    end
  end
end

%!shared none
%! none = struct ('folder', cell (1, 0));
%!assert (isempty (checkStore (tempname (), tempdir (), none, 1)))
%!test
%! model = struct ('folder', fileparts (which ('checkStore')));
%! p = checkStore (tempname (), tempdir (), model, 1e15);
%! assert (p.id, 'DEcalioc:checkCase:diskSpace');
%!test
%! file = tempname ();
%! fclose (fopen (file, 'w'));
%! p = checkStore (fullfile (file, 'x'), tempdir (), none, 1);
%! assert (p.id, 'DEcalioc:checkCase:badStore');
%! unlink (file);
%!assert (checkStore ('/proc/x', tempdir (), none, 1).id, ...
%!        'DEcalioc:checkCase:storeNotWritable')
