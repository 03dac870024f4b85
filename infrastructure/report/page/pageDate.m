% PAGEDATE  When the result of a report is from.
%
% CALL: TEXT = pageDate (PAGE)
%
%   PAGE  see pageData
%
% See also: writePage

function text = pageDate (page)
  text = 'no result yet';
  for source = {'progress', 'calibration'}
    date = jsonAt (page.sources, {source{1}, 'date'});
    if ischar (date)
      text = date;
    end
  end
  file = fullfile (page.Case.folder, 'gap', 'gap.json');
  if ~isempty (page.sources.gap) && isfile (file)
    made = strftime ('%Y-%m-%d %H:%M', localtime (stat (file).mtime));
    text = [strrep(['calibrated ', text, ', '], ...
                   'calibrated no result yet, ', ''), 'diagnosed ', made];
  end
end

%!test
%! page.sources = struct ('calibration', ...
%!                        struct ('date', '2026-01-02 03:04'), ...
%!                        'progress', [], 'gap', []);
%! page.Case.folder = '';
%! assert (pageDate (page), '2026-01-02 03:04');
%! page.sources.calibration = [];
%! assert (pageDate (page), 'no result yet');
