% WRITEHEAD  Appends the variables of a run to its data.head.
%
% CALL: writeHead (MODEL, MODELVARS, FOLDERNAME, BASE)
%
%   MODEL       name of the model (text)
%   MODELVARS   scalar struct of numbers, one field per variable
%   FOLDERNAME  name of the run's folder (text)
%   BASE        folder that holds optim/ (text, default pwd)
%
% See also: assignParams

function writeHead (model, modelVars, folderName, base)
  if nargin < 4
    base = pwd ();
  end
  file = fullfile (base, 'optim', model, folderName, 'data.head');
  writeAtomic (file, [fileread(file), "\n", headLines(modelVars)], false);
end

%!test
%! base = tempname ();
%! mkdir (fullfile (base, 'optim', 'M', '0001'));
%! file = fullfile (base, 'optim', 'M', '0001', 'data.head');
%! writeAtomic (file, 'variable a equal 1');
%! writeHead ('M', struct ('a', 0.1, 'b', 5e6), '0001', base);
%! assert (headDefaults (file), struct ('a', 0.1, 'b', 5e6));

% SPDX-License-Identifier: GPL-3.0-only
