% CREATENEWFOLDER  Makes the folder of a run and copies the model into it.
%
% CALL: DONE = createNewFolder (MODEL, FOLDERNAME, BASE, SOURCE)
%
%   MODEL       name of the model (text)
%   FOLDERNAME  name of the run's folder (text)
%   BASE        folder that holds optim/ (text, default pwd)
%   SOURCE      model folder (text, default BASE/DEMmodels/MODEL)
%   DONE        false where the folder is there already
%
% Errors: those of makeRunFolder and copyModel
%
% See also: makeRunFolder, copyModel, newFolderName

function done = createNewFolder (model, folderName, base, source)
  if nargin < 3
    base = pwd ();
  end
  if nargin < 4
    source = fullfile (base, 'DEMmodels', model);
  end
  folder = fullfile (base, 'optim', model, folderName);
  done = makeRunFolder (folder);
  if done
    copyModel (folder, source);
  end
end

%!test
%! base = tempname ();
%! mkdir (fullfile (base, 'DEMmodels', 'M'));
%! writeAtomic (fullfile (base, 'DEMmodels', 'M', 'data.head'), 'x');
%! assert (createNewFolder ('M', '0001', base));
%! assert (! createNewFolder ('M', '0001', base));
%! assert (fileread (fullfile (base, 'optim', 'M', '0001', 'data.head')), 'x');
%!error id=DEcalioc:makeRunFolder:cannotWrite
%! createNewFolder ('M', '0001', '/proc/nowhere', '/tmp');

% SPDX-License-Identifier: GPL-3.0-only
