% CREATENEWFOLDER  Makes the folder of a run and copies the model into it.
%
% CALL: DONE = createNewFolder (MODEL, FOLDERNAME, BASE, SOURCE)
%
%   MODEL       name of the model (text)
%   FOLDERNAME  name of the run's folder (text)
%   BASE        folder that holds optim/ (text, default pwd)
%   SOURCE      model folder (text, default BASE/DEMmodels/MODEL)
%   DONE        false where the folder is there already: another worker or
%               another Octave took the number, try the next one
%
% Links inside the model folder are followed, so that a run folder holds all
% it needs.
%
% Errors: DEcalioc:createNewFolder:cannotWrite
%
% See also: prepareRun, newFolderName

function done = createNewFolder (model, folderName, base, source)
  if nargin < 3
    base = pwd ();
  end
  if nargin < 4
    source = findModel (model, base, base);
  end
  parent = fullfile (base, 'optim', model);
  [~, ~] = mkdir (parent);
  folder = fullfile (parent, folderName);
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
  error ('DEcalioc:createNewFolder:cannotWrite', ...
         ['createNewFolder: %s must be writable, got: %s. Free some space ' ...
          'or correct the permissions and start again; finished runs are ' ...
          'kept.'], folder, why);
end

%!test
%! base = tempname ();
%! mkdir (fullfile (base, 'DEMmodels', 'M'));
%! writeAtomic (fullfile (base, 'DEMmodels', 'M', 'data.head'), 'x');
%! assert (createNewFolder ('M', '0001', base));
%! assert (! createNewFolder ('M', '0001', base));
%! assert (fileread (fullfile (base, 'optim', 'M', '0001', 'data.head')), 'x');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (base, 's');
%!error id=DEcalioc:createNewFolder:cannotWrite
%! createNewFolder ('M', '0001', '/proc/nowhere', '/tmp');
