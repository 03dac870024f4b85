% GETRESULTS  Read the two results of a finished run of the container Lift100.
%
% CALL: res = getResults (model, folderName)
%
%   model        text: name of the model folder
%   folderName   text: name of the run's folder below optim/<model>
%   res          1 x 2 cell of scalars: bulk density of the filling (kg/m3),
%                mass that stays in the container after the discharge (kg); NaN
%                where a result is missing or not sane
%
% The global variable path holds the working folder with a slash at its end.
%
% See also: readContainer

function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "the published interface of models");
  global path
  res = readContainer ([path, 'optim/', model, '/', folderName]);
end
