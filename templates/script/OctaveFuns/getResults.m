% GETRESULTS  Results of a run of the model @MODEL@.
%
% CALL: RES = getResults (MODEL, FOLDERNAME)
%
%   MODEL       name of the model's folder below optim/ (text)
%   FOLDERNAME  name of the run's folder (text)
%   RES         cell of scalars, one a line of results.csv of the model, read
%               from the file @RESULTS@ of the run; NaN where one is missing
%
% Errors: DEcalioc:getResults:missingFile, DEcalioc:getResults:noResult (the file has
% none of the results)
%
% See also: readResults, resultInfo, readDump

function res = getResults (model, folderName)
  %| pragma Justify (metric, "globals", "the way in that runs have");
  global path
  here = fileparts (fileparts (mfilename ('fullpath')));
  names = {resultInfo(here).name};
  folder = [path, 'optim/', model, '/', folderName, '/'];
  share = str2double ('@SHARE@');      % of rows: the last ones whose mean counts
  res = num2cell (readResults ([folder, '@RESULTS@'], names, share));
  text = '';
  if all (isnan ([res{:}]))
    if ~isfile ([folder, '@RESULTS@'])
      error ('DEcalioc:getResults:missingFile', 'the run has not written @RESULTS@');
    end
    text = strtrim (readText ([folder, '@RESULTS@']));
  end
  if ~isempty (text) && isempty (regexpi (text, '\<nan\>', 'once'))
    error ('DEcalioc:getResults:noResult', ...
           ['@RESULTS@ must hold %d number(s) alone, lines NAME VALUE, or columns, of ' ...
            '%s; it begins with: %s'], numel (names), strjoin (names, ', '), ...
           strtok (text, "\n")(1:min (end, 80)));
  end
end
