% MAKERUNFOLDER  Makes the folder of a run and copies the model into it.
%
% CALL: DONE = makeRunFolder (FOLDER, SOURCE)
%
% FOLDER  folder of the run (text)
% SOURCE  model folder (text)
% DONE    false where the folder is there already: another worker or another
%         Octave took its number, try the next one
%
% Links inside the model folder are followed, so that a run folder holds all
% it needs.
%
% Errors: DEcalioc:makeRunFolder:cannotWrite
%
% See also: prepareRun, createNewFolder

function done = makeRunFolder (folder, source)
  [~, ~] = mkdir (fileparts (folder));
  [made, why] = mkdir (folder);
  done = made && isempty (why);
  if ~made && ~isfolder (folder)
    refuse (folder, why);
  end
  if done
    [status, why] = system (['cp -rL ', shellQuote([source, '/.']), ' ', ...
                             shellQuote([folder, '/']), ' 2>&1']);
    if status ~= 0
      refuse (folder, strtrim (why));
    end
  end
end

function refuse (folder, why)
  error ('DEcalioc:makeRunFolder:cannotWrite', ...
         ['makeRunFolder: %s must be writable, got: %s. Free some space ' ...
          'or correct the permissions and start again; finished runs are ' ...
          'kept.'], folder, why);
end

%!test
%! base = tempname ();
%! source = fullfile (base, 'M');
%! mkdir (source);
%! writeAtomic (fullfile (source, 'data.head'), 'x');
%! folder = fullfile (base, 'optim', 'M', '0001');
%! assert (makeRunFolder (folder, source));
%! assert (! makeRunFolder (folder, source));
%! assert (fileread (fullfile (folder, 'data.head')), 'x');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (base, 's');
%!error id=DEcalioc:makeRunFolder:cannotWrite
%! makeRunFolder ('/proc/nowhere/optim/M/0001', '/tmp');
