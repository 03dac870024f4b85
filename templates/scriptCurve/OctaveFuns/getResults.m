% GETRESULTS  Results of a run of the model @MODEL@.
%
% CALL: RES = getResults (MODEL, FOLDERNAME)
%
%   MODEL       name of the model's folder below optim/ (text)
%   FOLDERNAME  name of the run's folder (text)
%   RES         struct: of each curve two columns, place and value, NaN where the
%               run has none; of each other line of results.csv a number. Read from
%               the file @RESULTS@ of the run
%
% See also: readSeries, readResults, resultInfo

function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "the way in that runs have");
  global path
  file = [path, 'optim/', model, '/', folderName, '/@RESULTS@'];
  curves = {@CURVES@};                 % column of the place, column of the value
  here = fileparts (fileparts (mfilename ('fullpath')));
  names = setdiff ({resultInfo(here).name}, curves(:, 2)', 'stable');
  share = str2double ('@SHARE@');      % of rows: the last ones whose mean counts
  values = num2cell (readResults (file, names, share));
  res = cell2struct (values(:), names(:), 1);
  text = '';
  if isfile (file)
    text = readText (file);
  end
  for curve = curves'
    points = readSeries (text, curve');
    if isempty (points)
      points = NaN (1, 2);
    end
    res.(curve{2}) = points;
  end
end
