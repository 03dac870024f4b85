% MAKERUNFOLDER  Takes the folder of a run: makes it, if it is not there yet.
%
% CALL: DONE = makeRunFolder (FOLDER)
%
% FOLDER  folder of the run (text)
% DONE    false where the folder is there already: another worker or another
%         Octave took its number, try the next one
%
% Errors: DEcalioc:makeRunFolder:cannotWrite

function done = makeRunFolder (folder)
  [~, ~] = mkdir (fileparts (folder));
  [made, why] = mkdir (folder);
  done = made && isempty (why);
  if ~made && ~isfolder (folder)
    inTheWay = fileAbove (folder);
    if ~isempty (inTheWay)
      error ('DEcalioc:makeRunFolder:cannotWrite', ...
             ['makeRunFolder: %s must be a folder, got a file. Move it away and start ' ...
              'again.'], inTheWay);
    end
    error ('DEcalioc:makeRunFolder:cannotWrite', ...
           ['makeRunFolder: %s must be writable, got: %s. Free some space ' ...
            'or correct the permissions and start again; finished runs are ' ...
            'kept.'], folder, why);
  end
end

% '' where no file stands in the place of a folder.
function file = fileAbove (folder)
  file = folder;
  while ~isempty (file) && ~isfile (file) && ~strcmp (file, fileparts (file))
    file = fileparts (file);
  end
  if ~isfile (file)
    file = '';
  end
end

%!test
%! folder = fullfile (tempname (), 'optim', 'M', '0001');
%! assert (makeRunFolder (folder));
%! assert (! makeRunFolder (folder));
%!test
%! base = emptyFolder ();
%! writeAtomic (fullfile (base, 'optim'), "x\n");
%! fail ('makeRunFolder (fullfile (base, ''optim'', ''M'', ''0001''))', ...
%!       'optim must be a folder, got a file');
%!error id=DEcalioc:makeRunFolder:cannotWrite
%! makeRunFolder ('/proc/nowhere/optim/M/0001');

% SPDX-License-Identifier: GPL-3.0-only
