% WRITEPARAMS  Writes the parameter set of a run into its folder.
%
% CALL: writeParams (MODEL, MATR, FOLDERNAME, BASE)
%
%   MODEL       name of the model (text)
%   MATR        1 x (d + 2): the parameters, the row of the plan (0: none) and
%               the number of the model
%   FOLDERNAME  name of the run's folder (text)
%   BASE        folder that holds optim/ (text, default pwd)
%
% Makes params.csv (15 digits) and, for a run of the plan, ExPlan.txt.
%
% See also: writeSet, writeHead, Start

function writeParams (model, matr, folderName, base)
  if nargin < 4
    base = pwd ();
  end
  writeSet (fullfile (base, 'optim', model, folderName), ...
            matr(1:end - 2), matr(end - 1));
end

%!test
%! base = tempname ();
%! folder = fullfile (base, 'optim', 'M', '0001');
%! mkdir (folder);
%! writeParams ('M', [0.1, 1/3, 4, 1], '0001', base);
%! assert (csvread (fullfile (folder, 'params.csv')), [0.1, 1/3], 1e-15);
%! assert (str2double (fileread (fullfile (folder, 'ExPlan.txt'))), 4);

% SPDX-License-Identifier: GPL-3.0-only
