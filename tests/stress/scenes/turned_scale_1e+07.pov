#version 3.7;
global_settings{assumed_gamma 1.0 max_trace_level 60 adc_bailout 0 }
background{rgb 0.0}
camera{perspective location <0.0,15000000.0,-60000000.0> direction <0.0,0.0,1.5> right <1.0,-0.0,0.0> up <0.0,1.0,0.0>}
light_source{<-40000000.0,60000000.0,-50000000.0> rgb 1}
plane{<0.0,1.0,0.0>,0.0 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} }}
sphere{<0.0,10000000.0,0.0>,10000000.0 pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} }}
box{<-5000000.0,-5000000.0,5000000.0>,<5000000.0,5000000.0,-5000000.0> pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} } rotate <-31.0,-17.0,53.0> translate <19000000.0,10000000.0,-5000000.0>}
triangle{<-30000000.0,0.0,10000000.0>,<-10000000.0,0.0,20000000.0>,<-20000000.0,25000000.0,15000000.0> pigment{rgb 1} finish{ambient 0 emission 0.0 diffuse 0.9 specular 0 phong 0 reflection{0.0} }}
