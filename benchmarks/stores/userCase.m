% USERCASE  A stand-in case of one of two users, for twoUsers.
%
% CALL: C = userCase (HOME, STORE, K, RIG)
%       TEXT = userCase (P, POINTS, REMARK)      its measured.csv
%
%   HOME    folder to be made for the user (text), with the case in it
%   STORE   folder of the store (text)
%   K       1 or 2, number of the user
%   RIG     value of a fixed variable: runs of another one count for nobody
%   P       1 x 2, parameters whose results were measured, without scatter
%   POINTS  how many places of the curve were measured
%   REMARK  lines that come first (text)
%   C       scalar struct: folder (of the case), home, uid, store, truth (P),
%           pid (0), id (''), starts (0), hit (-Inf), points (3)
%
% Two models give a + b, a b, a - b and the curve a t + b, and a billionth of
% the seed, after a second of sleep.
%
% See also: twoUsers, standInCase

function C = userCase (varargin)
  if nargin == 3
    C = measuredText (varargin{:});
    return
  end
  [place, store, k, rig] = varargin{:};
  truths = [4, 3; 4.4, 3.2];
  C = struct ('folder', fullfile (place, 'case'), 'home', place, 'uid', ...
              1000 + k, 'store', store, 'truth', truths(k, :), 'pid', 0, ...
              'id', '', 'starts', 0, 'hit', -Inf, 'points', 3);
  [~, ~] = mkdir (place);
  raw = standInCase (C.folder);
  for name = raw.Input.model
    writeModel (fullfile (C.folder, 'DEMmodels', name{1}));
  end
  writeLoadInput (C.folder, ...
                  sprintf (["modelVars.rig = %d;\n", ...
                            "optim = rmfield (optim, 'targetVal');\n", ...
                            "optim.tolRes = 0.01;\nInput.store = '%s';"], ...
                           rig, store));
  writeAtomic (fullfile (C.folder, 'measured.csv'), ...
               measuredText (C.truth, C.points, ''));
end

function writeModel (model)
  put = @(name, varargin) writeAtomic (fullfile (model, name), ...
                                       sprintf ('%s\n', varargin{:}));
  put ('data.head', 'variable a equal 1', 'variable b equal 1', ...
       'variable rig equal 0', 'variable runSeed equal 15485863');
  put ('runscript', 'sleep 1', 'awk -f model.awk data.head > out');
  put ('model.awk', 'BEGIN { OFMT = CONVFMT = "%.15g" }', ...
       '$1 == "variable" { v[$2] = $4 }', ...
       'END { a = v["a"]; b = v["b"]', ...
       '  e = 1e-9 * v["runSeed"] + 0 * v["rig"]', ...
       '  print a + b + e, a * b + e, a - b + e', ...
       '  for (t = 1; t < 6; t++) print t, a * t + b + e, 0 }');
  put ('results.csv', 'name,kind,unit,series,at,text', ...
       'sum,mass,kg,,,a + b', 'product,mass,kg,,,a b', ...
       'difference,mass,kg,,,a - b', 'growth,mass,kg,,,a t + b');
  put (fullfile ('OctaveFuns', 'getResults.m'), ...
       'function res = getResults (model, folderName)', 'global path', ...
       'M = load ([path, ''optim/'', model, ''/'', folderName, ''/out'']);', ...
       'res = struct (''sum'', M(1, 1), ''product'', M(1, 2), ...', ...
       '              ''difference'', M(1, 3), ''growth'', ...', ...
       '              M(2:end, 1:2));', 'end');
end

function text = measuredText (p, points, remark)
  line = @(model, name, value) sprintf ('%s;%s;%.12g;0.01;kg;;;;\n', model, ...
                                        name, value);
  text = [remark, "model;name;value;sd;unit;repeats;role;series;at\n", ...
          line('First', 'sum', p(1) + p(2)), ...
          line('First', 'product', p(1) * p(2)), ...
          line('Second', 'difference', p(1) - p(2))];
  for t = 1:points
    text = [text, sprintf('First;;%.12g;0.01;kg;;;growth;%d\n', ...
                          p(1) * t + p(2), t)];
  end
end

%!test
%! C = userCase (tempname (), tempname (), 2, 0);
%! here = cd (C.folder);
%! back = onCleanup (@() cd (here));
%! clear loadInput
%! Case = loadCase (fileparts (fileparts (which ('startToolbox'))), C.folder);
%! clear loadInput
%! assert ([Case.targets.value], [7.6, 14.08, 7.6, 12, 16.4, 1.2], 1e-9);
%! for k = 1:2
%!   writeAtomic (fullfile (Case.models(k).folder, 'runscript'), ...
%!                "awk -f model.awk data.head > out\n");
%! end
%! assert (evaluateDEM (C.truth, Case), [Case.targets.value], 1);
